// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/gpu/support/touching_bodies.h"

#include <algorithm>
#include <cmath>

#include "tests/deform/support/obstacle_shapes.h"
#include "tests/deform/support/tool_oracles.h"
#include "tests/deform/support/two_bars.h"

namespace hepatica::test {
namespace {

Tool with_pad(Tool tool) {
    tool.target_mm = tool.centre_mm();
    tool.pad_mm = 0.3;
    tool.pressure_pa = 1e6;
    tool.friction = 0.3;
    return tool;
}

// Above the bar's middle, a little aside of its vertices.
Tool probe(const Vec3& half_axis_mm) {
    return with_pad(single_tool(Capsule{Vec3(30.4, 2.8, 8.2), half_axis_mm, 2.0}));
}

Tool forceps() {
    Tool tool;
    for (const double side : {-0.5, 0.5})
        tool.parts.push_back({.shape = {.centre_mm = Vec3(31.0, 3.0, 3.0 + side * 10.4),
                                        .half_axis_mm = Vec3(0.0, 5.0, 0.0),
                                        .radius_mm = 2.0},
                              .opens = side * Vec3::UnitZ()});
    tool.opening_mm = tool.opening_target_mm = 6.4;
    return with_pad(tool);
}

// A shaft beside the bar and a foot below it.
Tool hook() {
    Tool tool;
    tool.parts.push_back({.shape = {.centre_mm = Vec3(30.4, -2.0, 5.0),
                                    .half_axis_mm = Vec3(0.0, 0.0, 6.8),
                                    .radius_mm = 1.5}});
    tool.parts.push_back({.shape = {.centre_mm = Vec3(30.4, 1.5, -1.8),
                                    .half_axis_mm = Vec3(0.0, 3.5, 0.0),
                                    .radius_mm = 1.5}});
    return with_pad(tool);
}

Grab hand_nearest(const BodyDescription& body, const Vec3& place_mm) {
    const auto& x = body.mesh.vertices_mm;
    const auto nearest = std::ranges::min_element(
        x, {}, [&](const Vec3& at) { return (at - place_mm).squaredNorm(); });
    Grab grab;
    grab.vertices[0] = static_cast<int>(nearest - x.begin());
    grab.target_mm = *nearest;
    grab.stiffness_un_per_mm = 5e4;
    grab.force_limit_un = 2e5;
    return grab;
}

TouchingBody bar_and(const Tool& tool, const Vec3& mm_per_step) {
    TouchingBody made{.description = bar(), .tool = tool, .tool_mm_per_step = mm_per_step};
    return made;
}

TouchingBody bar_below_a_ball() {
    TouchingBody made{.description = bar()};
    made.description.touchable = false;
    made.description.obstacles = one_obstacle(ball_surface(Vec3(30.3, 3.2, 10.5), 4.0));
    made.grab = hand_nearest(made.description, Vec3(33, 3, 3));
    made.grab_mm_per_step = Vec3(0.01, 0.0, 0.03);
    return made;
}

// The upper one is pulled onto the lower, and along it.
TouchingBody bars_that_cross(double friction) {
    TouchingBody made{.description = crossed_bars(0.5)};
    for (const Vec3& x : made.description.mesh.vertices_mm)
        made.description.fixed.push_back(x.z() < 2.1 && std::abs(x.x()) > 11.9 ? 1 : 0);
    made.description.tether_pa_per_mm2 = 1.0;
    made.description.self->friction = friction;
    made.grab = hand_nearest(made.description, Vec3(0.3, 0.2, 4.5));
    made.grab_mm_per_step = Vec3(0.01, 0.02, -0.03);
    return made;
}

TouchingBody everything() {
    TouchingBody made = bars_that_cross(0.3);
    made.description.touchable = true;
    made.description.obstacles = one_obstacle(ball_surface(Vec3(5.0, 0.3, -5.2), 3.0));
    made.tool = with_pad(single_tool(Capsule{Vec3(-7.1, 0.2, 4.3), Vec3(0.0, 1.0, 0.0), 2.0}));
    made.tool_mm_per_step = Vec3(0.0, 0.01, -0.04);
    return made;
}

}  // namespace

TouchingBody touching_body(const std::string& kind) {
    if (kind == "probe") return bar_and(probe(Vec3::Zero()), Vec3(0.01, 0.02, -0.03));
    if (kind == "rod") return bar_and(probe(Vec3(0.5, 6.0, 0.3)), Vec3(0.02, 0.0, -0.03));
    if (kind == "forceps") {
        TouchingBody made = bar_and(forceps(), Vec3(0.02, 0.0, 0.005));
        made.closing_mm_per_step = 0.04;
        return made;
    }
    if (kind == "hook") return bar_and(hook(), Vec3(0.01, 0.01, 0.03));
    if (kind == "obstacle") return bar_below_a_ball();
    if (kind == "self") return bars_that_cross(0.0);
    if (kind == "self-friction") return bars_that_cross(0.3);
    return everything();
}

void lead(TouchingBody& body, StepBackEnd& back_end, double dt_s) {
    if (body.grab) {
        body.grab->target_mm += body.grab_mm_per_step;
        back_end.set_grabs({&*body.grab, 1});
    }
    if (!back_end.tool()) return;
    Tool tool = *back_end.tool();
    tool.target_mm += body.tool_mm_per_step;
    tool.opening_target_mm = std::max(0.0, tool.opening_target_mm - body.closing_mm_per_step);
    back_end.set_tool(tool);
    back_end.lead_tool(1.0, dt_s);
}

}  // namespace hepatica::test
