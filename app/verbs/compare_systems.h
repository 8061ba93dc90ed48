// SPDX-License-Identifier: GPL-3.0-or-later
// The form of `compare` that judges each vascular system by its own mask.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/command_line.h"

namespace hepatica {

struct SystemsToCompare {
    std::filesystem::path patient;
    std::vector<std::string> truth_masks;  // NAME=FILE each
    std::filesystem::path liver_mask;      // may be empty
    std::filesystem::path cava_mask;       // may be empty
};

// Whether a value of --truth-mask names a system: NAME=FILE.
bool names_a_system(const std::string& truth_mask);

// Announces and begins its own stages. Throws UsageError, InputError, Cancelled.
Json compare_systems(const SystemsToCompare& request, Job& job);

// Its answer as tables for people: one row for each system, one for each class of radii.
Json tables_of_systems(const Json& answer);

}  // namespace hepatica
