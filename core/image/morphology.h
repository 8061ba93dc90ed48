// SPDX-License-Identifier: GPL-3.0-or-later
// Morphology of masks: exact Euclidean distances (Felzenszwalb and Huttenlocher 2012), dilation,
// erosion, closing and opening by a ball of a physical radius, connected components, holes. All
// give the same bytes for any number of threads; functions that take a job throw Cancelled.
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/job.h"
#include "core/image/filters.h"
#include "core/image/volume.h"

namespace hepatica {

// Distance in mm from each voxel's centre to the nearest centre of an object voxel (0 inside);
// infinity if there is no object. The spacing may differ between axes.
FloatVolume distance_to(const Mask& object, Job& job);
// Negative inside: minus the distance to the nearest background voxel; positive outside: distance
// to the nearest object voxel.
FloatVolume signed_distance(const Mask& object, Job& job);

// By a ball of radius_mm (>= 0). The outside of the image counts as background for dilation and as
// object for erosion. Closing treats the outside as background of an unbounded space: it neither
// removes an object voxel nor grows towards the border.
Mask dilate(const Mask& mask, double radius_mm, Job& job);
Mask erode(const Mask& mask, double radius_mm, Job& job);
Mask close(const Mask& mask, double radius_mm, Job& job);
// The closing inside a box of voxels, which is clipped to the grid: the same as crop(close(...)),
// at the cost of the box and its surroundings within twice the radius. Throws InputError if nothing
// of the box lies in the grid.
Mask close_in(const Mask& mask, double radius_mm, const IndexBox& where, Job& job);
Mask open(const Mask& mask, double radius_mm, Job& job);

enum class Connectivity { faces6 = 6, all26 = 26 };

struct Components {
    Image<std::uint32_t> labels;  // 0 background, 1 the largest component, 2 the next ...
    // sizes[i]: voxels of label i + 1, descending; ties by first voxel.
    std::vector<std::size_t> sizes;
};

Components connected_components(const Mask& mask, Connectivity connectivity,
                                const Job& job = Job());
// The `count` largest components, without those of fewer than minimum_voxels, as 0 and 1.
Mask largest_components(const Mask& mask, Connectivity connectivity, int count = 1,
                        std::size_t minimum_voxels = 1);
// Fills background that no path through faces connects to the border of the image. The result is 0
// and 1.
Mask fill_holes(const Mask& mask, const Job& job = Job());

}  // namespace hepatica
