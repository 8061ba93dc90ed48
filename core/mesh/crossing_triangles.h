// SPDX-License-Identifier: GPL-3.0-or-later
// Which triangles of a surface cross each other, by exact predicates.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/base/vector.h"

namespace hepatica {

// Pairs (a < b), ascending, of triangles that share a point other than a common corner or a common
// edge. Touching counts; the answer is exact for the coordinates as they are. Two with a common
// edge, and triangles without an area, never count. Positions are finite. Pure function; costs a
// sort along x and a test for each pair of boxes that meet.
std::vector<std::array<int, 2>> crossing_triangles(std::span<const std::array<int, 3>> triangles,
                                                   std::span<const Vec3> positions_mm);

}  // namespace hepatica
