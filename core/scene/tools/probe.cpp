// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/tools/tool_kinds.h"

namespace hepatica {

void make_probe(Tool& tool, const ToolChoice& choice, const Vec3& direction, const Vec3& point_mm) {
    Capsule shape{.radius_mm = choice.radius_mm};
    if (choice.kind == "capsule") shape.half_axis_mm = 0.5 * choice.length_mm * direction;
    shape.centre_mm = point_mm - shape.half_axis_mm - shape.radius_mm * direction;
    tool.parts.push_back({.shape = shape});
    tool.friction = 0.2;
}

}  // namespace hepatica
