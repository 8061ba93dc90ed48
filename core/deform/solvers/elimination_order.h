// SPDX-License-Identifier: GPL-3.0-or-later
// The order in which a tree-shaped body is eliminated: from its ends inward, cross-section after
// cross-section, towards the node that halves the body. A front then spans one cross-section, and
// the branches on either side of that node depend on nothing in common until the last.
#pragma once

#include <vector>

#include "core/deform/solvers/frame_skeleton.h"

namespace hepatica {

// A permutation of the vertices of `binding`, first eliminated first.
std::vector<int> order_from_ends(const FrameSkeleton& skeleton, const FrameBinding& binding);

}  // namespace hepatica
