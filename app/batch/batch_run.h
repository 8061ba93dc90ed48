// SPDX-License-Identifier: GPL-3.0-or-later
// Many CTs one after the other: each becomes a case, a picture and a record; one that fails does
// not stop the rest; a batch that was stopped goes on with the patients that have no record.
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
    bool retry = false;              // those that failed, too
    bool keep_names = false;         // call patients as their scans are called, not by pseudonyms
    ReconstructOptions reconstruct;  // of each; ct and liver_mask are not read
};

// {out, patients, done, failed, made_now, summary, page}. Throws InputError where nothing can be
// begun; Cancelled, with the records of all that was finished and a table that says so.
nlohmann::ordered_json run_batch(const BatchOptions& options, Job& job);

}  // namespace hepatica
