// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of each kind of tool where it has arrived at a point; the choice is in range, and
// `direction` has the length 1.
#pragma once

#include "core/scene/tools/tool_choice.h"

namespace hepatica {

// A sphere or a capsule whose tip is at the point.
void make_probe(Tool& tool, const ToolChoice& choice, const Vec3& direction, const Vec3& point_mm);

}  // namespace hepatica
