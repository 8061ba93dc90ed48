// SPDX-License-Identifier: GPL-3.0-or-later
// Assigns each voxel of an organ to the nearest branch of a tree, along paths from voxel to voxel
// within the organ, so that a fissure separates its two sides. A discrete geodesic Voronoi diagram
// by Dijkstra's algorithm (1959) over the 26 neighbours; on a cubic grid lengths are at most 13 %
// too long: sqrt(1 + (sqrt 2 - 1)^2 + (sqrt 3 - sqrt 2)^2).
#pragma once

#include <cstdint>
#include <span>

#include "core/base/job.h"
#include "core/image/volume.h"
#include "core/tree/vessel_tree.h"

namespace hepatica {

inline constexpr std::int32_t no_owner = -1;

// The owner of the nearest centreline for each voxel of `organ` that is not 0; no_owner elsewhere.
//   owners: one number per segment, no_owner for segments that own nothing; without any owner all
//   voxels are no_owner
// An owner's voxels are connected to its centrelines through the organ and the lumens of owning
// segments, which count as passable because masks of organs often lack them. Voxels that no such
// path reaches get the owner that is nearest in a straight line. Among equal lengths the lower
// number wins. O(n log n) in the organ's voxels, on one thread; deterministic. Reports progress in
// the present stage; throws Cancelled.
Image<std::int32_t> nearest_branch(const Mask& organ, const VesselTree& tree,
                                   std::span<const std::int32_t> owners, Job& job);

}  // namespace hepatica
