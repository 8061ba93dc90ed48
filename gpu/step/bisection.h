// SPDX-License-Identifier: GPL-3.0-or-later
// Nested dissection of a forest: it is cut in halves, again and again. Nodes of two branches that
// meet at a cut share elements, so that a cut takes two neighbouring nodes.
#pragma once

#include <array>
#include <vector>

#include "core/deform/solvers/coarse_skeleton.h"

namespace hepatica::gpu {

// Every node once, in the order of elimination: the cuts that divide most come last. The second
// node of a cut is -1 where its neighbour is gone already.
std::vector<std::array<int, 2>> bisecting_cuts(const CoarseSkeleton& skeleton);

}  // namespace hepatica::gpu
