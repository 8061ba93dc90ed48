// SPDX-License-Identifier: GPL-3.0-or-later
// A recording names its patient by a hash alone: finds the case that it was made of beside it.
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
    std::vector<std::string> passed_over;  // cases that cannot be read, and why, in words
};

// Finds the first case, by name, in the folder of `file` whose patient has this hash (hash_of() of
// core/patient/patient_case.h). Reading a case costs a second at most. Throws Cancelled.
CaseSearch case_beside(const std::filesystem::path& file, std::uint64_t patient_hash, Job& job);

}  // namespace hepatica
