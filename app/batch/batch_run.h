// SPDX-License-Identifier: GPL-3.0-or-later
// Reconstructs many CTs one after another: each yields a case, a picture and a record. A failure
// does not stop the rest, and an interrupted batch resumes with the patients without a record.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>

#include "core/base/job.h"
#include "core/reconstruction/reconstruct.h"

namespace hepatica {

struct BatchOptions {
    std::filesystem::path folder, out;
    std::filesystem::path liver_masks;  // a folder; empty: none
    int task = 1;                       // this program's share of `tasks`
    int tasks = 1;
    bool retry = false;              // also retry those that failed
    bool keep_names = false;         // name patients by their scans, not by pseudonyms
    ReconstructOptions reconstruct;  // for each patient; ct and liver_mask are not read
};

// Returns {out, patients, done, failed, made_now, summary, page}. Throws InputError where the batch
// cannot begin, and Cancelled after writing the records of all that was finished and the summary.
nlohmann::ordered_json run_batch(const BatchOptions& options, Job& job);

}  // namespace hepatica
