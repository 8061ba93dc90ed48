// SPDX-License-Identifier: GPL-3.0-or-later
// Intensity filters: crop, resample, Gaussian smoothing. All of them run in parallel and give the
// same bytes for any number of threads.
#pragma once

#include <Eigen/Geometry>

#include "core/base/job.h"
#include "core/image/volume.h"

namespace hepatica {

// A box of voxels: first index and one past the last index along each axis.
struct IndexBox {
    Index3 begin{0, 0, 0};
    Index3 end{0, 0, 0};

    bool empty() const { return begin[0] >= end[0] || begin[1] >= end[1] || begin[2] >= end[2]; }
};

// The smallest box that holds every voxel that is not zero; empty where there is none.
IndexBox bounding_box(const Mask& mask);
// The box grown by margin_mm on each side and clipped to the grid.
IndexBox grow_box(const IndexBox& box, const Grid& grid, double margin_mm);
// The box in space that holds the middles of a box's voxels; empty where that is.
Eigen::AlignedBox3d box_mm(const IndexBox& box, const Grid& grid);

// The voxels of the box, in the same place in space. The box is clipped to the grid first; throws
// InputError where nothing is left.
Volume crop(const Volume& volume, const IndexBox& box);
FloatVolume crop(const FloatVolume& volume, const IndexBox& box);
Mask crop(const Mask& mask, const IndexBox& box);
Grid crop(const Grid& grid, const IndexBox& box);

// The grid with another spacing (each > 0) that covers the same extent, voxel borders included, to
// within half a new voxel on each side; same centre and direction.
Grid respaced(const Grid& grid, const Vec3& spacing_mm);

enum class Interpolation { nearest, linear, cubic };  // cubic: Catmull-Rom

// The image on another grid. Outside the source's voxels the nearest border value continues.
// Where the target is coarser than the source, smooth first.
Volume resample(const Volume& volume, const Grid& target, Interpolation how, Job& job);
FloatVolume resample(const FloatVolume& volume, const Grid& target, Interpolation how, Job& job);
// A mask at another spacing, 0 or 1 whatever its labels: linear interpolation of the share inside,
// cut at one half (or nearest).
Mask resample(const Mask& mask, const Grid& target, Interpolation how, Job& job);

// resample() onto respaced(): spacing below the source's own is allowed along each axis.
Volume resample_to_spacing(const Volume& volume, const Vec3& spacing_mm, Interpolation how,
                           Job& job);

FloatVolume to_float(const Volume& volume);

// Smooths with a Gaussian of the given standard deviation along each axis (0 leaves an axis as it
// is); the border value continues outside. From 2 voxels on by Deriche's fourth-order recursive
// filter, below by the sampled kernel. Works in place, in memory of a few lines beyond the image.
void gaussian_smooth(FloatVolume& image, const Vec3& sigma_mm, Job& job);

}  // namespace hepatica
