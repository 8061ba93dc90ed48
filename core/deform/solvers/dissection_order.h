// SPDX-License-Identifier: GPL-3.0-or-later
// Nested dissection (George 1973) of any pattern, by levels of distance from an end of each part
// (George and Liu 1978): what lies on both sides of a level is eliminated before it. Where bodies
// are thick, or tied to each other all along their sides, it fills less than minimum degree does.
#pragma once

#include <vector>

#include "core/deform/solvers/block_matrix.h"

namespace hepatica {

// The order in which the vertices are eliminated. Parts that are small are ordered by minimum
// degree. Takes a few times as long as fill_reducing_order.
std::vector<int> dissection_order(const BlockMatrix& pattern);

}  // namespace hepatica
