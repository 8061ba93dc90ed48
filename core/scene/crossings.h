// SPDX-License-Identifier: GPL-3.0-or-later
// How often a scene's vessels pass through each other or through obstacles, by exact predicates;
// contact must keep this at zero.
#pragma once

#include <array>
#include <span>
#include <vector>

#include <functional>

#include "core/scene/deform_part.h"

namespace hepatica {

// Number of pairs of surface triangles that cross now, for surfaces that touch each other in the
// scene. Not counted are pairs that overlapped at rest and have not separated yet, and the sides of
// a tear that still lie on each other, that is, whose split vertices are nearer than the critical
// opening. Costs a search over the whole surface.
int crossing_pairs(const DeformPart& deform);

// The same for a whole body, given its surface triangles and its positions at rest and now; `kept`
// are the overlaps that have not separated.
int crossing_pairs(const std::vector<std::array<int, 3>>& triangles, std::span<const Vec3> rest_mm,
                   std::span<const Vec3> now_mm, const OverlapsKept& kept);

// Whether two vertices that a split made of one are still together.
using StillTogether = std::function<bool(int node, int other)>;

// The same for a torn body. Not counted are triangles with vertices that are still together.
int crossing_pairs(const TornTopology& torn, const StillTogether& together,
                   std::span<const Vec3> rest_mm, std::span<const Vec3> now_mm,
                   const OverlapsKept& kept);

}  // namespace hepatica
