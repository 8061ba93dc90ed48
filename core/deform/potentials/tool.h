// SPDX-License-Identifier: GPL-3.0-or-later
// An instrument that pushes: a sphere or a capsule in a soft pad. Where it is led it goes, as far
// as what it meets lets it; no speed makes it pass through anything.
#pragma once

#include <limits>

#include "core/base/vector.h"
#include "core/contact/capsule.h"

namespace hepatica {

struct Tool {
    Capsule shape;
    Vec3 target_mm = Vec3::Zero();  // where its centre is led
    // By what and over what time it was led last: it drags what it touches.
    Vec3 led_by_mm = Vec3::Zero();
    double led_over_s = 1.0;  // > 0
    // The pad around it: its thickness, > 0, and its pressure where it is pressed to half of that,
    // > 0. Pressed by the share g it answers with pressure * g / (1 - g).
    double pad_mm = 0.0;
    double pressure_pa = 0.0;
    double friction = 0.0;  // Coulomb's coefficient, >= 0
    // It is not led further against a greater force, > 0.
    double force_limit_un = std::numeric_limits<double>::max();

    Vec3 velocity_mm_per_s() const { return led_by_mm / led_over_s; }
};

// What the body does to the tool.
struct ToolLoad {
    Vec3 force_un = Vec3::Zero();
    Vec3 torque_un_mm = Vec3::Zero();  // about the tool's centre
    Vec3 impulse_un_s = Vec3::Zero();  // over the step: forces at the ends of its parts times dt
    int contacts = 0;                  // points of the body in the pad
    double least_gap_mm = std::numeric_limits<double>::max();  // of these
};

}  // namespace hepatica
