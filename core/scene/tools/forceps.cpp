// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/tools/tool_kinds.h"

namespace hepatica {
namespace {

// Distance from the jaws' tips to the point between them, as a share of their length.
constexpr double place_from_tips = 0.25;
constexpr double friction_of_teeth = 0.6;

}  // namespace

void make_forceps(Tool& tool, const ToolChoice& choice, const Vec3& direction,
                  const Vec3& point_mm) {
    const Vec3 side = side_of(choice, direction);
    const Vec3 centre = point_mm - (0.5 - place_from_tips) * choice.length_mm * direction;
    tool.opening_mm = tool.opening_target_mm = jaws_open_to_radii * choice.radius_mm;
    for (const double which : {-0.5, 0.5})
        tool.parts.push_back(
            {.shape = {.centre_mm =
                           centre + which * (tool.opening_mm + 2.0 * choice.radius_mm) * side,
                       .half_axis_mm = 0.5 * choice.length_mm * direction,
                       .radius_mm = choice.radius_mm},
             .opens = which * side});
    tool.friction = friction_of_teeth;
}

}  // namespace hepatica
