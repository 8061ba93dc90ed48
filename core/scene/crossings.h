// SPDX-License-Identifier: GPL-3.0-or-later
// How often a scene's vessels pass through each other or through obstacles, by exact predicates:
// what contact promises never to happen.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/scene/deform_part.h"

namespace hepatica {

// Pairs of surface triangles that cross as the body lies now, of those surfaces that touch each
// other in the scene, outside of what overlapped at rest and has not come apart yet, and of the
// sides of a tear that still lie on each other: nearer than the critical opening, at a vertex that
// was split. Costs a search over the whole surface.
int crossing_pairs(const DeformPart& deform);

// Likewise of a body that is whole, with its surface's triangles, at rest and as it lies now;
// `kept` says what overlapped at rest and has not come apart.
int crossing_pairs(const std::vector<std::array<int, 3>>& triangles, std::span<const Vec3> rest_mm,
                   std::span<const Vec3> now_mm, const OverlapsKept& kept);

}  // namespace hepatica
