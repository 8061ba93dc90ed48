// SPDX-License-Identifier: GPL-3.0-or-later
// The small patient's vessels, which tools may touch, and a ball that comes from above.
#pragma once

#include "tests/session/new_session.h"

namespace hepatica::test {

inline SceneSpec touchable() {
    SceneSpec spec = default_scene();
    spec.flow.reset();
    spec.contact = ContactSpec{};
    return spec;
}

inline AddTool ball(double radius_mm = 2.0) {
    return {.radius_mm = radius_mm,
            .direction = Vec3(0, 0, -1),
            .point_mm = middle_of(small_patient()->tree, 1)};
}

}  // namespace hepatica::test
