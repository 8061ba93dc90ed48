// SPDX-License-Identifier: GPL-3.0-or-later
// The table and the page of a batch, summary.csv and index.html, generated from its records.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/batch/batch_record.h"

namespace hepatica {

// One line per patient (CSV, RFC 4180): patient, state (done, failed or to do), seconds,
// vessels_mm, liver_ml, doubts in words, reason of a failure.
std::string batch_table(const std::filesystem::path& out, const std::vector<std::string>& patients);

// Writes both files atomically. Several programs may do so at once; the last one wins.
void write_batch_report(const std::filesystem::path& out, const std::vector<std::string>& patients);

}  // namespace hepatica
