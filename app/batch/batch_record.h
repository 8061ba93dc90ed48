// SPDX-License-Identifier: GPL-3.0-or-later
// What a batch remembers of each patient, one file each, written when he is done or has failed; and
// what it was begun with. Whoever goes on reads these alone, so that several programs can share one
// folder.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/patient/patient_case.h"

namespace hepatica {

struct BatchRecord {
    std::string patient;
    bool done = false;     // else it failed
    double seconds = 0.0;  // wall time
    std::string reason;    // of a failure: what, where and what to do
    double vessels_mm = 0.0;
    double liver_ml = 0.0;            // 0: no segments
    std::vector<std::string> doubts;  // in words
    bool has_picture = false;
};

// The file in `out` by which it is known to be a batch's folder.
inline constexpr const char* batch_mark = "batch.json";

// Takes possession of `out`, or goes on in it. Throws InputError where it is no batch's folder and
// not empty, and where it was begun with other options.
void open_batch(const std::filesystem::path& out, const nlohmann::ordered_json& options);

// Nothing where a patient has none yet; what is damaged counts as none.
std::optional<BatchRecord> read_record(const std::filesystem::path& out,
                                       const std::string& patient);
void write_record(const std::filesystem::path& out, const BatchRecord& record);

// Facts of a patient that was reconstructed.
BatchRecord record_of(const std::string& name, const PatientCase& patient,
                      const std::vector<std::string>& warnings, double seconds);

}  // namespace hepatica
