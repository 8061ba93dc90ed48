// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/tool_at_body.h"

#include <algorithm>

#include "core/contact/capsule.h"
#include "core/scene/tools/tool_choice.h"

namespace hepatica {

namespace {

// Counts as the limit, because a tool moves in increments and stops before exceeding it.
constexpr double at_limit_share = 0.9;

// The obstacles that a tool cannot pass: see ToolObstacle.
std::vector<const Obstacle*> solids_of(const Obstacles* obstacles) {
    std::vector<const Obstacle*> solids;
    if (obstacles == nullptr) return solids;
    for (const Obstacle& obstacle : obstacles->all)
        if (obstacle.kind == SurfaceKind::solid) solids.push_back(&obstacle);
    return solids;
}

}  // namespace

Tool brought_from_outside(Tool tool, const Vec3& direction,
                          const std::vector<std::array<int, 3>>& surface,
                          std::span<const Vec3> positions_mm, const Obstacles* obstacles) {
    const std::vector<const Obstacle*> solids = solids_of(obstacles);
    // Starts outside: farther away than anything of a plausible body.
    Box box;
    for (const Vec3& x : positions_mm) box.add(x);
    for (const Obstacle* solid : solids)
        for (const Vec3& x : solid->surface.vertices_mm) box.add(x);
    Vec3 length = Vec3::Zero();
    for (const ToolPart& part : tool.parts) {
        box.add(part.shape.centre_mm);
        const Vec3 half = part.shape.half_axis_mm + part.shape.radius_mm * direction;
        if (half.norm() > length.norm()) length = half;
    }
    const Vec3 way = (box.high - box.low).norm() * direction;
    const Vec3 there = tool.parts.front().shape.centre_mm;
    for (ToolPart& part : tool.parts) part.shape.centre_mm -= way;
    for (ToolPart& part : tool.parts) part.shape.centre_mm -= 2.0 * length;
    const SurfacePatches patches(surface);
    Vec3 gone = approach(tool.shapes(), {{patches, positions_mm}},
                         there - tool.parts.front().shape.centre_mm, tool.pad_mm);
    for (const Obstacle* solid : solids)
        gone = approach(tool.shapes(),
                        {{SurfacePatches(solid->surface.triangles), solid->surface.vertices_mm}},
                        gone, tool.pad_mm);
    for (ToolPart& part : tool.parts) part.shape.centre_mm += gone;
    tool.target_mm = tool.centre_mm();
    return tool;
}

ToolView view_of(const Tool& tool, const ToolLoad& load) {
    ToolView view;
    const auto share = 1.0 / static_cast<double>(tool.parts.size());
    for (const ToolPart& part : tool.parts) {
        const Segment axis = part.shape.axis();
        view.parts.push_back({axis[0], axis[1], part.shape.radius_mm});
        view.tip_mm += share * axis[1];
    }
    view.centre_mm = tool.centre_mm();
    view.opening_mm = tool.opening_mm;
    view.force_un = load.force_un;
    view.at_mm = load.at_mm;
    constexpr double rounding_mm = 1e-9;
    view.closing = tool.opening_target_mm < widest_opening_mm(tool) - rounding_mm;
    // What open jaws touch on their way is not held.
    view.grip_un = view.closing ? load.grip_un : 0.0;
    view.at_limit =
        std::max(load.force_un.norm(), load.grip_un) >= at_limit_share * tool.force_limit_un;
    view.touched = load.touched;
    return view;
}

}  // namespace hepatica
