// SPDX-License-Identifier: GPL-3.0-or-later
// A skeleton with as many nodes as a mesh can use. A patient's centreline has a node for every
// voxel or two, and its mesh may have fewer vertices than the coarse space then has vectors:
// factoring it costs more than the whole step, and every node hears of many others.
#pragma once

#include <span>

#include "core/deform/solvers/coarse_skeleton.h"

namespace hepatica::gpu {

// Keeps the roots, and of each way down the tree a node as soon as so many vertices, 1 or more, are
// bound to those since the last one that was kept. Others are left out, ends and bifurcations, too:
// what was bound to them is bound to the edges that are left. Deterministic.
CoarseSkeleton thinned(const CoarseSkeleton& skeleton, std::span<const Vec3> rest_positions_mm,
                       int least_vertices);

}  // namespace hepatica::gpu
