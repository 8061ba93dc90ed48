// SPDX-License-Identifier: GPL-3.0-or-later
// Which branch of a tree each voxel of an organ is nearest to, by travel through the organ: a path
// from voxel to voxel that never leaves it, so that a fissure parts what lies on its two sides. A
// discrete geodesic Voronoi diagram by Dijkstra's method (1959) over the 26 neighbours; on a
// cubic grid lengths are at most 13 % too long, sqrt(1 + (sqrt 2 - 1)^2 + (sqrt 3 - sqrt 2)^2).
#pragma once

#include <cstdint>
#include <span>

#include "core/base/job.h"
#include "core/image/volume.h"
#include "core/tree/vessel_tree.h"

namespace hepatica {

inline constexpr std::int32_t no_owner = -1;

// Of each object voxel of `organ` the owner of the nearest centreline; no_owner elsewhere.
//   owners: one number per segment, no_owner for segments that own nothing. At least one must own
//   something that lies within the patient (else all voxels are no_owner).
// Every owner's voxels hang together with its centrelines, through the organ and the lumens of the
// owning segments, which count as passable although masks of organs often leave them out. Pieces of
// the organ that no such path reaches get the owner that is nearest in a straight line. Of equal
// travels the lower number wins. Costs O(n log n) in object voxels; the same bytes always, on one
// thread. Reports progress in the present stage; throws Cancelled.
Image<std::int32_t> nearest_branch(const Mask& organ, const VesselTree& tree,
                                   std::span<const std::int32_t> owners, Job& job);

}  // namespace hepatica
