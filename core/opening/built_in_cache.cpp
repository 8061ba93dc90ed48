// SPDX-License-Identifier: GPL-3.0-or-later
// Implements the cache as a folder with a case and a label file, replaced atomically; digests
// detect damage and other programs.
#include "core/opening/built_in_cache.h"

#include <algorithm>
#include <exception>
#include <string_view>
#include <vector>

#include "core/base/atomic_write.h"
#include "core/base/error.h"
#include "core/base/sha256.h"
#include "core/base/text_file.h"
#include "core/patient/case_header.h"
#include "core/reconstruction/built_in_patient.h"

namespace hepatica {
namespace {

namespace fs = std::filesystem;

// The entry is a folder with a case and a label. The lines of the label are: the digest of the
// lines below; the key; the digest of case.json, which holds those of all other files.
fs::path entry_of(const BuiltInCache& cache) {
    return cache.folder / "built_in_patient";
}
constexpr const char* case_name = "patient.hep";
constexpr const char* label_name = "label.txt";

std::string digest_of(std::string_view text) {
    Sha256 digest;
    digest.add_bytes(text.data(), text.size());
    return digest.hex_digest();
}

std::string key_of(const BuiltInCache& cache) {
    return digest_of(cache.program + '\n' + built_in_parameters());
}

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        lines.push_back(text.substr(begin, end - begin));
        begin = end + 1;
    }
    return lines;
}

// The content of the label; empty where it is missing or cannot be read.
std::string label_of(const BuiltInCache& cache) {
    try {
        return read_text_file(entry_of(cache) / label_name, "");
    } catch (const InputError&) {
        return {};
    }
}

// The digest of case.json. None where the label is missing, damaged or written for another program.
std::optional<std::string> kept_case_digest(const BuiltInCache& cache) {
    if (cache.folder.empty()) return std::nullopt;
    const std::string text = label_of(cache);
    const std::size_t first_line = text.find('\n');
    if (first_line == std::string::npos) return std::nullopt;
    const std::string below = text.substr(first_line + 1);
    std::vector<std::string> lines = lines_of(below);
    if (text.substr(0, first_line) != digest_of(below) || lines.size() != 2 ||
        lines[0] != key_of(cache))
        return std::nullopt;
    return lines[1];
}

void write_label(const fs::path& folder, const BuiltInCache& cache) {
    const std::string below =
        key_of(cache) + '\n' + sha256_of_file(folder / case_name / case_file::header) + '\n';
    write_text_atomically(folder / label_name, digest_of(below) + '\n' + below);
}

}  // namespace

bool holds_patient(const BuiltInCache& cache) {
    return kept_case_digest(cache).has_value();
}

fs::path case_of(const BuiltInCache& cache) {
    return holds_patient(cache) ? entry_of(cache) / case_name : fs::path();
}

std::optional<PatientCase> patient_of(const BuiltInCache& cache) {
    try {
        const std::optional<std::string> digest = kept_case_digest(cache);
        if (!digest) return std::nullopt;
        const fs::path folder = entry_of(cache) / case_name;
        if (sha256_of_file(folder / case_file::header) != *digest) return std::nullopt;
        PatientCase patient = read_case(folder);
        if (!cache.with_dial) patient.dial_json.clear();  // the label does not vouch for it
        return patient;
    } catch (const std::exception&) {
        return std::nullopt;
    }
}

void keep(const BuiltInCache& cache, const PatientCase& patient) {
    if (cache.folder.empty()) return;
    try {
        fs::create_directories(cache.folder);
        write_folder_atomically(entry_of(cache), [&](const fs::path& temporary) {
            write_case(temporary / case_name, patient);
            write_label(temporary, cache);
        });
    } catch (const std::exception&) {
        // A cache that cannot be written only costs time at the next start.
    }
}

}  // namespace hepatica
