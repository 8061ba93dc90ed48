// SPDX-License-Identifier: GPL-3.0-or-later
// An instrument that touches: one or several capsules in a soft pad, which keep their places to
// each other but for jaws that open and close. Where it is led it goes, as far as what it meets
// lets it; no speed makes it pass through anything.
#pragma once

#include <limits>
#include <span>
#include <vector>

#include "core/base/vector.h"
#include "core/contact/capsule.h"

namespace hepatica {

struct ToolPart {
    Capsule shape;
    // Where its centre goes for each millimetre by which the tool opens; 0 but for jaws.
    Vec3 opens = Vec3::Zero();
    // The last displacement of its centre and of its half axis, with which it drags the body.
    Vec3 led_by_mm = Vec3::Zero();
    Vec3 led_half_axis_mm = Vec3::Zero();
};

struct Tool {
    std::vector<ToolPart> parts;  // one or more
    double opening_mm = 0.0;      // how far it is open, >= 0; 0 where it has no jaws
    // Where it is led: its centre, how far it is still to turn about that (a vector along the axis,
    // as long as the angle in radians), and how far it is to open, >= 0.
    Vec3 target_mm = Vec3::Zero();
    Vec3 turn_rad = Vec3::Zero();
    double opening_target_mm = 0.0;
    double led_over_s = 1.0;  // > 0, over which its parts were led last
    // The pad around it: its thickness, > 0, and its pressure where it is pressed to half of that,
    // > 0. Pressed by the share g it answers with pressure * g / (1 - g).
    double pad_mm = 0.0;
    double pressure_pa = 0.0;
    double friction = 0.0;  // Coulomb's coefficient, >= 0
    // It is not led further against a greater force, > 0; nor does it close.
    double force_limit_un = std::numeric_limits<double>::max();

    // The mean of its parts' centres.
    Vec3 centre_mm() const;
    std::vector<Capsule> shapes() const;
    std::vector<Capsule> shapes_before_led() const;
    // The speed of the end that moved farthest in its last displacement.
    double speed_mm_per_s() const;
    // The distance from its centre to its farthest end.
    double reach_mm() const;
};

// One capsule.
Tool single_tool(const Capsule& shape);

// What the body and obstacles do to the tool.
struct ToolLoad {
    Vec3 force_un = Vec3::Zero();
    Vec3 torque_un_mm = Vec3::Zero();  // about the tool's centre
    double grip_un = 0.0;              // with which jaws are pressed apart; 0 without jaws
    Vec3 at_mm = Vec3::Zero();  // the mean of its contacts, weighted by their forces; 0 without
    Vec3 impulse_un_s = Vec3::Zero();  // of the body alone, over the step: forces at the ends of
                                       // its parts times dt
    int contacts = 0;                  // points of the body in the pad
    double least_gap_mm = std::numeric_limits<double>::max();  // of all that is in the pad
    std::vector<int> touched;  // nodes of the triangles in the pad, each once, ascending
};

}  // namespace hepatica
