// SPDX-License-Identifier: GPL-3.0-or-later
// Shared by the readers of tree files.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/tree/files/tree_io.h"
#include "core/tree/vessel_tree.h"

namespace hepatica {

// The content of a file. Throws InputError, naming it, where it cannot be read.
std::string read_text(const std::filesystem::path& file);

// Factors that turn coordinates of a space into LPS.
inline Vec3 signs_to_lps(PatientSpace space) {
    return space == PatientSpace::ras ? Vec3(-1, -1, 1) : Vec3(1, 1, 1);
}

// Throws InputError where numbers of systems in a file without names are ambiguous (tree_io.h).
void require_unambiguous_systems(const std::vector<int>& numbers,
                                 const std::filesystem::path& file);

// Throws InputError where a radius is outside 0.001 to 1000 mm. `what` has it: "a vessel".
void require_plausible_radius(double radius_mm, const std::string& what, const std::string& place);

// validate() with the file as the place. Also throws InputError for a tree without a segment, for
// positions outside the patient's space and for radii outside 0.001 to 1000 mm.
void validate_from_file(const VesselTree& tree, const std::filesystem::path& file);

}  // namespace hepatica
