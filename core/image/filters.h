// SPDX-License-Identifier: GPL-3.0-or-later
// Intensity filters: crop, resample, Gaussian smoothing. They run in parallel and give the same
// bytes for any number of threads. Functions that take a job throw Cancelled.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>

#include "core/base/job.h"
#include "core/image/volume.h"

namespace hepatica {

// A box of voxels: first index and one past the last index along each axis.
struct IndexBox {
    Index3 begin{0, 0, 0};
    Index3 end{0, 0, 0};

    bool empty() const { return begin[0] >= end[0] || begin[1] >= end[1] || begin[2] >= end[2]; }
};

// The smallest box that contains every nonzero voxel; empty if there is none.
IndexBox bounding_box(const Mask& mask);
// The box grown by margin_mm on each side and clipped to the grid.
IndexBox grow_box(const IndexBox& box, const Grid& grid, double margin_mm);
// The axis-aligned box in space that contains the centres of a box's voxels; empty for an empty
// box.
Eigen::AlignedBox3d box_mm(const IndexBox& box, const Grid& grid);

// The voxels of the box, at the same position in space. The box is clipped to the grid first;
// throws InputError if nothing is left.
Volume crop(const Volume& volume, const IndexBox& box);
FloatVolume crop(const FloatVolume& volume, const IndexBox& box);
Mask crop(const Mask& mask, const IndexBox& box);
Grid crop(const Grid& grid, const IndexBox& box);

// Puts a part into the whole image from voxel `begin` on: undoes crop(). The part must fit.
template <class T>
void paste(const Image<T>& part, const Index3& begin, Image<T>& whole) {
    const Index3& dims = part.grid.dims;
    for (int z = 0; z < dims[2]; ++z)
        for (int y = 0; y < dims[1]; ++y)
            std::copy_n(&part.at(0, y, z), dims[0],
                        &whole.at(begin[0], begin[1] + y, begin[2] + z));
}

// The grid with another spacing (each > 0) that covers the same extent, voxel borders included, to
// within half a new voxel on each side; same centre and direction. Throws InputError for a spacing
// that is not positive or makes more than 32767 voxels along an axis.
Grid respaced(const Grid& grid, const Vec3& spacing_mm);

enum class Interpolation { nearest, linear, cubic };  // cubic: Catmull-Rom

// The image on another grid. Outside the source the nearest border value is repeated. Where the
// target is coarser than the source, smooth first. Throws InputError where memory is insufficient.
Volume resample(const Volume& volume, const Grid& target, Interpolation how, Job& job);
FloatVolume resample(const FloatVolume& volume, const Grid& target, Interpolation how, Job& job);
// A mask on another grid, as 0 and 1 whatever its labels: linear interpolation of the indicator
// function, 1 from one half on (or nearest neighbour).
Mask resample(const Mask& mask, const Grid& target, Interpolation how, Job& job);
// The same, linearly, but 0 beyond the mask's own grid: a mask that is cut to its object has the
// object at its border, and that would be repeated.
Mask resample_within(const Mask& mask, const Grid& target, Job& job);

FloatVolume to_float(const Volume& volume);

// Smooths with a Gaussian of the given standard deviation along each axis (0 skips an axis); the
// border value is repeated outside. From 2 voxels on with Deriche's fourth-order recursive filter,
// whose cost does not depend on sigma, below with the sampled kernel. In place, with memory for a
// few lines. Throws InputError for a negative or non-finite sigma.
void gaussian_smooth(FloatVolume& image, const Vec3& sigma_mm, Job& job);

}  // namespace hepatica
