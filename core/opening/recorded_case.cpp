// SPDX-License-Identifier: GPL-3.0-or-later
// Reads the cases of a folder one after the other and compares their hashes.
#include "core/opening/recorded_case.h"

#include <algorithm>
#include <system_error>
#include <vector>

#include "core/base/error.h"
#include "core/patient/patient_case.h"

namespace hepatica {

namespace fs = std::filesystem;

namespace {

std::vector<fs::path> cases_in_the_folder_of(const fs::path& file) {
    std::vector<fs::path> cases;
    std::error_code failed;
    for (fs::directory_iterator at(fs::absolute(file).parent_path(), failed), end;
         !failed && at != end; at.increment(failed))
        if (is_case(at->path())) cases.push_back(at->path());
    std::ranges::sort(cases);
    return cases;
}

}  // namespace

CaseSearch case_beside(const fs::path& file, std::uint64_t patient_hash, Job& job) {
    CaseSearch search;
    for (const fs::path& folder : cases_in_the_folder_of(file)) {
        job.throw_if_cancelled();
        try {
            if (hash_of(read_case_without_voxels(folder)) != patient_hash) continue;
            search.found = folder;
            return search;
        } catch (const InputError& error) {
            search.passed_over.push_back(folder.string() + " is passed over: " + error.problem());
        }
    }
    return search;
}

}  // namespace hepatica
