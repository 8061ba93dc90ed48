// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the case that a recording was made of: a recording names its patient only by a hash, and
// the case is sought in the same folder.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/base/job.h"

namespace hepatica {

struct CaseSearch {
    std::optional<std::filesystem::path> found;
    std::vector<std::string> passed_over;  // one message for each case that could not be read
};

// Finds the first case, by name, in the folder of `file` whose patient has this hash (hash_of() of
// core/patient/patient_case.h). Takes up to a second for each case. Throws Cancelled.
CaseSearch case_beside(const std::filesystem::path& file, std::uint64_t patient_hash, Job& job);

}  // namespace hepatica
