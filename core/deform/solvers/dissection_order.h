// SPDX-License-Identifier: GPL-3.0-or-later
// Nested dissection (George 1973) of any pattern, with level sets as separators (George and Liu
// 1978): both sides of a separator are eliminated before it. For thick bodies, or bodies tied to
// each other along their sides, it gives less fill than minimum degree.
#pragma once

#include <vector>

#include "core/deform/solvers/block_matrix.h"

namespace hepatica {

// The order in which the vertices are eliminated. Small parts are ordered by minimum degree. Takes
// a few times as long as fill_reducing_order.
std::vector<int> dissection_order(const BlockMatrix& pattern);

}  // namespace hepatica
