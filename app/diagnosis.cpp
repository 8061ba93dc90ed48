// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/diagnosis.h"

#include <fstream>
#include <string>
#include <thread>

#include "core/base/error.h"
#include "core/base/program_files.h"
#include "gpu/machine/device_machine.h"

namespace hepatica {
namespace {

using Json = nlohmann::ordered_json;

std::string processor_name() {
    std::ifstream info("/proc/cpuinfo");
    for (std::string line; std::getline(info, line);)
        if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
    return "unknown";
}

// Parses "name version" entries joined by commas, as CMake found them.
Json library_versions() {
    Json versions = Json::object();
    const std::string list = HEPATICA_VERSIONS;
    for (std::size_t begin = 0; begin < list.size();) {
        const std::size_t end = std::min(list.find(',', begin), list.size());
        const std::string entry = list.substr(begin, end - begin);
        const std::size_t space = entry.find(' ');
        versions[entry.substr(0, space)] = entry.substr(space + 1);
        begin = end + 1;
    }
    return versions;
}

Json text_or_null(const std::string& text) {
    return text.empty() ? Json(nullptr) : Json(text);
}

// The state of CUDA; without a device, `reason` says why in words.
Json cuda() {
    const gpu::DeviceInfo info = gpu::device_info();
    return {{"compiled", info.compiled},
            {"architectures", text_or_null(info.architectures)},
            {"device", text_or_null(info.device)},
            {"memory_bytes", info.device.empty() ? Json(nullptr) : Json(info.memory_bytes)},
            {"driver", text_or_null(info.driver)},
            {"reason", text_or_null(info.reason)}};
}

// The folder of the program's own files.
Json own_files() {
    try {
        return asset("scripts").parent_path().string();
    } catch (const InputError&) {
        return nullptr;
    }
}

}  // namespace

nlohmann::ordered_json diagnosis() {
    return {{"version", HEPATICA_VERSION},
            {"files", own_files()},
            {"cpu", {{"name", processor_name()}, {"threads", std::thread::hardware_concurrency()}}},
            {"cuda", cuda()},
            {"libraries", library_versions()}};
}

}  // namespace hepatica
