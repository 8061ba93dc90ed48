// SPDX-License-Identifier: GPL-3.0-or-later
// What the readers of tree files have in common.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/tree/files/tree_io.h"
#include "core/tree/vessel_tree.h"

namespace hepatica {

// A file's bytes. Throws InputError that names it where it cannot be read.
std::string read_text(const std::filesystem::path& file);

// What turns positions of a space into LPS, coordinate by coordinate.
inline Vec3 signs_to_lps(PatientSpace space) {
    return space == PatientSpace::ras ? Vec3(-1, -1, 1) : Vec3(1, 1, 1);
}

// Throws InputError where the numbers of the systems, in a file that does not name them, may mean
// two things: see tree_io.h.
void require_unambiguous_systems(const std::vector<int>& numbers,
                                 const std::filesystem::path& file);

// validate() with the file named as the place; also refuses positions beyond 10 m and radii that no
// vessel has.
void validate_from_file(const VesselTree& tree, const std::filesystem::path& file);

}  // namespace hepatica
