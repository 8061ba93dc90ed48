// SPDX-License-Identifier: GPL-3.0-or-later
// Tumours given as masks, in the labels of organs.nii.gz.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/job.h"
#include "core/image/volume.h"

namespace hepatica {

// Reads masks of tumours. Each 26-connected piece of their nonzero voxels is a tumour, numbered 1,
// 2, ... from the largest on, on the CT's grid; 0 elsewhere. Pieces beyond most_tumours are left
// out, and `warnings` says so. Masks may cover a box of the CT's voxels. Begins one stage for each
// file. Throws InputError where a file cannot be read or does not fit; Cancelled.
Mask read_tumours(const std::vector<std::filesystem::path>& files, const Grid& ct_grid,
                  std::vector<std::string>& warnings, Job& job);

// Of tumours that lie, wholly or by a hundredth at least, outside this grid of the organs, where a
// case keeps nothing of them, `warnings` says so. Throws Cancelled.
void warn_of_tumours_outside(const Mask& tumours, const Grid& organs,
                             std::vector<std::string>& warnings, const Job& job);

// Labels the organs, on any grid, organ_label::first_tumour + number - 1 where a tumour lies.
void add_tumours(const Mask& tumours, Mask& organs);

}  // namespace hepatica
