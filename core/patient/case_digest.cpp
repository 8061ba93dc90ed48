// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/patient/case_digest.h"

#include <system_error>

#include "core/base/sha256.h"
#include "core/patient/case_folder.h"
#include "core/patient/case_header.h"

namespace hepatica {

namespace fs = std::filesystem;

std::string digest_of_case(const fs::path& place) {
    if (!is_case(place)) return {};
    try {
        return in_folder(place, [](const fs::path& folder) {
            Sha256 digest;
            for (const char* name : {case_file::header, case_file::measurements}) {
                std::error_code ignored;
                const std::string of_file =
                    fs::exists(folder / name, ignored) ? sha256_of_file(folder / name) : "none";
                digest.add_bytes(of_file.data(), of_file.size());
            }
            return digest.hex_digest();
        });
    } catch (const InputError&) {
        return "unreadable";
    }
}

}  // namespace hepatica
