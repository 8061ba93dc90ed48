// SPDX-License-Identifier: GPL-3.0-or-later
// Checks whether a truth is in the same place as the case to be judged.
#pragma once

#include <Eigen/Geometry>
#include <filesystem>
#include <string>

#include "core/image/volume.h"
#include "core/tree/vessel_tree.h"

namespace hepatica {

using BoxMm = Eigen::AlignedBox3d;

BoxMm box_of(const VesselTree& tree);
BoxMm box_of(const Mask& mask);  // of the centres of its nonzero voxels

// Rounded to whole millimetres, with the unit.
std::string text_of(double millimetres);

// The bounding boxes of vessels of the same scan overlap, however badly the vessels were found.
// Throws InputError where these do not; accepts anything where either is empty.
void require_overlap(const BoxMm& of_case, const std::filesystem::path& patient,
                     const BoxMm& of_truth, const std::filesystem::path& truth);

}  // namespace hepatica
