// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a truth lies where the case lies that it shall judge.
#pragma once

#include <Eigen/Geometry>
#include <filesystem>
#include <string>

#include "core/image/volume.h"
#include "core/tree/vessel_tree.h"

namespace hepatica {

using BoxMm = Eigen::AlignedBox3d;

BoxMm box_of(const VesselTree& tree);
BoxMm box_of(const Mask& mask);  // of the centres of its voxels that are not zero

// Whole millimetres in words.
std::string text_of(double millimetres);

// Vessels of one patient's scan share a place, however badly they were found. Throws InputError
// where these do not; nothing where either is empty.
void require_overlap(const BoxMm& of_case, const std::filesystem::path& patient,
                     const BoxMm& of_truth, const std::filesystem::path& truth);

}  // namespace hepatica
