// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/tools/tool_kinds.h"

namespace hepatica {
namespace {

constexpr double foot_of_length = 0.4;

}  // namespace

void make_hook(Tool& tool, const ToolChoice& choice, const Vec3& direction, const Vec3& point_mm) {
    const Vec3 bend = point_mm - choice.radius_mm * direction;
    const Vec3 shaft = 0.5 * choice.length_mm * direction;
    const Vec3 foot = 0.5 * foot_of_length * choice.length_mm * side_of(choice, direction);
    tool.parts.push_back(
        {.shape = {
             .centre_mm = bend - shaft, .half_axis_mm = shaft, .radius_mm = choice.radius_mm}});
    tool.parts.push_back(
        {.shape = {.centre_mm = bend + foot, .half_axis_mm = foot, .radius_mm = choice.radius_mm}});
    tool.friction = 0.2;
}

}  // namespace hepatica
