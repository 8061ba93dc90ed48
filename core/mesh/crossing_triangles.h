// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the triangles of a surface that cross each other, with exact predicates.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/base/vector.h"

namespace hepatica {

// Pairs (a < b), ascending, of triangles that share a point other than a common corner or a common
// edge. Touching counts; the result is exact for the given coordinates, which must be finite.
// Triangles with a common edge, and those without area, never count. Thread-safe. Cost: a sort
// along x, a comparison for each pair whose boxes overlap in x, and an exact test for each pair
// whose boxes overlap.
std::vector<std::array<int, 2>> crossing_triangles(std::span<const std::array<int, 3>> triangles,
                                                   std::span<const Vec3> positions_mm);

}  // namespace hepatica
