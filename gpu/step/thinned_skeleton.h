// SPDX-License-Identifier: GPL-3.0-or-later
// Thins a skeleton to as many nodes as a mesh can use. A patient's centreline has a node for every
// voxel or two, so a coarse mesh may have fewer unknowns than the coarse space; factoring it would
// then cost more than the whole step, and every node would be coupled with many others.
#pragma once

#include <span>

#include "core/deform/solvers/coarse_skeleton.h"

namespace hepatica::gpu {

// Keeps the roots, and along each path down the tree a node as soon as at least `least_vertices` >=
// 1 vertices are bound to the nodes since the last kept one. All others are dropped, even ends and
// bifurcations; their vertices are bound to the remaining edges. Deterministic.
CoarseSkeleton thinned(const CoarseSkeleton& skeleton, std::span<const Vec3> rest_positions_mm,
                       int least_vertices);

}  // namespace hepatica::gpu
