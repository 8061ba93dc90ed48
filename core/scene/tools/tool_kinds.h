// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of each kind of tool at its destination, a point. The choice must be in range and
// `direction` of length 1.
#pragma once

#include "core/scene/tools/tool_choice.h"

namespace hepatica {

// A sphere or a capsule with its tip at the point.
void make_probe(Tool& tool, const ToolChoice& choice, const Vec3& direction, const Vec3& point_mm);
// Two jaws, wide open, with the point between them, nearer to their tips.
void make_forceps(Tool& tool, const ToolChoice& choice, const Vec3& direction,
                  const Vec3& point_mm);
// A shaft that bends at the point into a foot of 0.4 of its length to its side.
void make_hook(Tool& tool, const ToolChoice& choice, const Vec3& direction, const Vec3& point_mm);

// The choice's side, made perpendicular to `direction` and of length 1; any where it has none.
Vec3 side_of(const ToolChoice& choice, const Vec3& direction);
constexpr double jaws_open_to_radii = 6.0;  // of the jaws' own radius, at most

}  // namespace hepatica
