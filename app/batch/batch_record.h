// SPDX-License-Identifier: GPL-3.0-or-later
// The record that a batch keeps of each patient, one file each, written when the patient is done or
// has failed; and the options of the batch. A batch resumes from these files alone, so several
// programs can share one folder.
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
    bool done = false;     // otherwise it failed
    double seconds = 0.0;  // wall time
    std::string reason;    // of a failure: problem, place and remedy
    double vessels_mm = 0.0;
    double liver_ml = 0.0;            // 0: not known
    std::vector<std::string> doubts;  // in words
    bool has_picture = false;
};

// The file that marks `out` as a batch's folder.
inline constexpr const char* batch_mark = "batch.json";

// Starts a batch in `out`, or resumes it. Throws InputError where it was begun with other options,
// and where its mark does not say with which.
void open_batch(const std::filesystem::path& out, const nlohmann::ordered_json& options);

// Nothing where a patient has no record, or an unreadable one.
std::optional<BatchRecord> read_record(const std::filesystem::path& out,
                                       const std::string& patient);
// Writes atomically. Throws InputError where it cannot be written.
void write_record(const std::filesystem::path& out, const BatchRecord& record);

// The record of a reconstructed patient.
BatchRecord record_of(const std::string& name, const PatientCase& patient,
                      const std::vector<std::string>& warnings, double seconds);

}  // namespace hepatica
