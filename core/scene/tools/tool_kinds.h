// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of each kind of tool where it has arrived at a point; the choice is in range, and
// `direction` has the length 1.
#pragma once

#include "core/scene/tools/tool_choice.h"

namespace hepatica {

// A sphere or a capsule whose tip is at the point.
void make_probe(Tool& tool, const ToolChoice& choice, const Vec3& direction, const Vec3& point_mm);
// Two jaws, wide open, with the point between them, nearer to their tips.
void make_forceps(Tool& tool, const ToolChoice& choice, const Vec3& direction,
                  const Vec3& point_mm);
// A shaft that bends at the point into a foot to its side, 0.4 of its length.
void make_hook(Tool& tool, const ToolChoice& choice, const Vec3& direction, const Vec3& point_mm);

// The choice's side, made square to `direction`; any where it has none.
Vec3 side_of(const ToolChoice& choice, const Vec3& direction);
constexpr double jaws_open_to_radii = 6.0;  // of their own, at most

}  // namespace hepatica
