// SPDX-License-Identifier: GPL-3.0-or-later
// Frames made by hand, and lessons for them.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "core/lesson/lesson.h"
#include "core/mesh/tet_mesh.h"
#include "core/scene/frame.h"
#include "tests/session/small_patient.h"

namespace hepatica::test {

// The small patient at rest.
inline Frame rest_frame() {
    static const auto surface = std::make_shared<const std::vector<std::array<int, 3>>>(
        boundary_triangles(small_patient()->mesh));
    Frame frame;
    frame.surface = surface;
    for (const Vec3& p : small_patient()->mesh.vertices_mm)
        for (int axis = 0; axis < 3; ++axis)
            frame.positions_mm.push_back(static_cast<float>(p[axis]));
    return frame;
}

inline Frame with_tip(const Vec3& tip_mm, const Vec3& force_un = Vec3::Zero()) {
    Frame frame = rest_frame();
    frame.tool.emplace();
    frame.tool->tip_mm = tip_mm;
    frame.tool->force_un = force_un;
    return frame;
}

inline Frame touching(bool touches) {
    Frame frame = with_tip(Vec3::Zero());
    if (touches) frame.tool->touched = {0};
    return frame;
}

inline Frame with_force(double force_un) {
    Frame frame = rest_frame();
    frame.grab.emplace();
    frame.grab->force_un = force_un;
    return frame;
}

// Steps of half a second, so that sums are exact.
inline Lesson plain_lesson() {
    Lesson lesson;
    lesson.name = "plain";
    lesson.scene.flow.reset();
    lesson.scene.dt_s = 0.5;
    lesson.steps.push_back({"go on", "", {{Quantity::time_s, -1, true, 1e9}}, 0.0, {}});
    return lesson;
}

}  // namespace hepatica::test
