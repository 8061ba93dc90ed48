// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/batch/batch_record.h"

#include <algorithm>
#include <cstdint>
#include <system_error>

#include "core/base/atomic_write.h"
#include "core/base/error.h"
#include "core/base/quoted_name.h"
#include "core/base/text_file.h"
#include "core/patient/liver_segments.h"

namespace hepatica {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

namespace {

fs::path file_of(const fs::path& out, const std::string& patient) {
    return out / "records" / (patient + ".json");
}

// Null where there is none. Throws InputError where it cannot be read.
Json read_json(const fs::path& file) {
    std::error_code ignored;
    if (!fs::exists(file, ignored)) return {};
    return Json::parse(read_text_file(file, "Move it away, or give another --out"), nullptr, false);
}

// Of the liver with its tumours; 0 where it is not known.
double liver_ml(const PatientCase& patient) {
    const Mask liver = liver_of(patient.organs);
    const auto voxels = static_cast<double>(
        std::ranges::count_if(liver.voxels, [](std::uint8_t voxel) { return voxel != 0; }));
    return voxels * liver.grid.spacing_mm.prod() / 1000.0;
}

}  // namespace

void open_batch(const fs::path& out, const Json& options) {
    const fs::path mark = out / batch_mark;
    // Asked once: another job of the same batch may write it meanwhile.
    const bool was_begun = fs::exists(mark);
    Json begun = was_begun ? read_json(mark) : Json();
    if (was_begun && !begun.is_object())
        throw InputError("is damaged: it says with which options the batch was begun",
                         mark.string(), "Put it back as it was, or give another --out");
    // Older versions always used the scans' names.
    if (begun.is_object() && !begun.contains("keep_names")) begun["keep_names"] = true;
    if (was_begun && nlohmann::json(begun) != nlohmann::json(options))
        throw InputError("was begun with other options", out.string(),
                         "Repeat those in " + mark.string() + ", or give another --out");
    fs::create_directories(out / "records");
    if (!was_begun) write_text_atomically(mark, options.dump(2) + "\n");
}

std::optional<BatchRecord> read_record(const fs::path& out, const std::string& patient) {
    const Json json = read_json(file_of(out, patient));
    if (!json.is_object()) return std::nullopt;
    try {
        BatchRecord record;
        record.patient = json.at("patient").get<std::string>();
        record.done = json.at("state").get<std::string>() == "done";
        record.seconds = json.at("seconds").get<double>();
        record.reason = json.at("reason").get<std::string>();
        record.vessels_mm = json.at("vessels_mm").get<double>();
        record.liver_ml = json.at("liver_ml").get<double>();
        record.doubts = json.at("doubts").get<std::vector<std::string>>();
        record.has_picture = json.at("picture").get<bool>();
        return record;
    } catch (const Json::exception&) {
        return std::nullopt;
    }
}

void write_record(const fs::path& out, const BatchRecord& record) {
    const Json json{{"patient", as_utf8(record.patient)},
                    {"state", record.done ? "done" : "failed"},
                    {"seconds", record.seconds},
                    {"reason", record.reason},
                    {"vessels_mm", record.vessels_mm},
                    {"liver_ml", record.liver_ml},
                    {"doubts", record.doubts},
                    {"picture", record.has_picture}};
    write_text_atomically(file_of(out, record.patient),
                          json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

BatchRecord record_of(const std::string& name, const PatientCase& patient,
                      const std::vector<std::string>& warnings, double seconds) {
    BatchRecord record;
    record.patient = name;
    record.done = true;
    record.seconds = seconds;
    record.vessels_mm = length_mm(patient.tree);
    record.liver_ml = liver_ml(patient);
    for (const std::string& warning : warnings) record.doubts.push_back(without_names(warning));
    return record;
}

}  // namespace hepatica
