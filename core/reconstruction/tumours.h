// SPDX-License-Identifier: GPL-3.0-or-later
// Tumours that somebody outlined, as organs.nii.gz keeps them.
#pragma once

#include <filesystem>
#include <vector>

#include "core/base/job.h"
#include "core/image/volume.h"

namespace hepatica {

// Each 26-connected piece of the masks' nonzero voxels is a tumour, the largest first: 1, 2, ... on
// the CT's grid, 0 elsewhere. Masks may cover a box of the CT's voxels. Begins a stage for each
// file. Throws InputError where a file cannot be read or does not fit, Cancelled.
Mask read_tumours(const std::vector<std::filesystem::path>& files, const Grid& ct_grid, Job& job);

// Writes organ_label::first_tumour + 0, 1, ... where the tumours lie into organs on any grid.
void add_tumours(const Mask& tumours, Mask& organs);

}  // namespace hepatica
