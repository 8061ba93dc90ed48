// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "core/scene/tools/tool_kinds.h"

namespace hepatica {
namespace {

// Distance from the jaws' tips to the point between them, as a share of their length.
constexpr double place_from_tips = 0.25;
constexpr double friction_of_teeth = 0.6;
// Thicker than other tools': in a step jaws take what they hold along by a part of it.
constexpr double pad_in_radii = 0.15;

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
    tool.pad_mm = std::clamp(pad_in_radii * choice.radius_mm, 0.1, 0.5);
}

}  // namespace hepatica
