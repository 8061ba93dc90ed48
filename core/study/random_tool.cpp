// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/random_tool.h"

#include <algorithm>

#include "core/scene/tools/tool_choice.h"
#include "core/study/touch_bodies.h"

namespace hepatica {

Vec3 random_direction(std::mt19937_64& random) {
    Vec3 d = Vec3::Zero();
    while (d.norm() < 0.1)
        for (int c = 0; c < 3; ++c) d[c] = uniform(random, -1.0, 1.0);
    return d.normalized();
}

Vec3 random_point(std::span<const Vec3> points_mm, std::mt19937_64& random) {
    const double number = uniform(random, 0.0, static_cast<double>(points_mm.size()));
    return points_mm[static_cast<std::size_t>(number)];
}

BodyExtent extent_of(const BodyDescription& body) {
    BodyExtent extent;
    for (const Vec3& x : body.mesh.vertices_mm) extent.middle_mm += x;
    extent.middle_mm /= static_cast<double>(body.mesh.vertices_mm.size());
    for (const Vec3& x : body.mesh.vertices_mm)
        extent.reach_mm = std::max(extent.reach_mm, (x - extent.middle_mm).norm());
    return extent;
}

Tool random_tool(const std::string& kind, const BodyDescription& body, const BodyExtent& extent,
                 std::mt19937_64& random) {
    ToolChoice choice;
    choice.kind = kind;
    choice.radius_mm = uniform(random, 0.5, 4.0);
    choice.length_mm = kind == "sphere" ? 0.0 : uniform(random, 3.0, 20.0);
    choice.direction = random_direction(random);
    const double away_mm = extent.reach_mm + 2.0 * choice.length_mm + 10.0 * choice.radius_mm;
    return tool_of(choice, extent.middle_mm - away_mm * choice.direction,
                   body.material.young_modulus_pa, hand_strain * body.material.young_modulus_pa);
}

}  // namespace hepatica
