// SPDX-License-Identifier: GPL-3.0-or-later
// A surgical instrument: one or several capsules with a soft pad. They form a rigid body except for
// jaws that open and close. The tool moves towards its target as far as contact allows; at no speed
// does it pass through anything.
#pragma once

#include <array>
#include <limits>
#include <span>
#include <vector>

#include "core/base/vector.h"
#include "core/contact/capsule.h"

namespace hepatica {

struct ToolPart {
    Capsule shape;
    // How far its centre moves per millimetre of opening; 0 except for jaws.
    Vec3 opens = Vec3::Zero();
    // The last displacement of its centre and of its half axis; friction drags the body along with
    // it.
    Vec3 led_by_mm = Vec3::Zero();
    Vec3 led_half_axis_mm = Vec3::Zero();
};

// The pad of a triangle that a tear has laid bare within the tool's pad; see thin_pads.h.
struct ThinPad {
    std::array<int, 3> corners{};  // its nodes, ascending
    double pad_mm = 0.0;           // > 0 and thinner than the tool's
};

struct Tool {
    std::vector<ToolPart> parts;  // at least one
    double opening_mm = 0.0;      // current opening, >= 0; 0 without jaws
    // The target: its centre, the remaining rotation about the centre (a rotation vector in
    // radians), and its opening, >= 0.
    Vec3 target_mm = Vec3::Zero();
    Vec3 turn_rad = Vec3::Zero();
    double opening_target_mm = 0.0;
    double led_over_s = 1.0;  // duration of the last displacement of its parts, > 0
    // The pad: its thickness, > 0, and its pressure where it is compressed to half, > 0. Compressed
    // by the share g it responds with pressure * g / (1 - g).
    double pad_mm = 0.0;
    std::vector<ThinPad> thin_pads{};  // ascending by corners
    double pressure_pa = 0.0;
    double friction = 0.0;  // Coulomb's coefficient, >= 0
    // Against a greater force the tool neither advances nor closes; > 0.
    double force_limit_un = std::numeric_limits<double>::max();

    // The mean of its parts' centres.
    Vec3 centre_mm() const;
    std::vector<Capsule> shapes() const;
    std::vector<Capsule> shapes_before_led() const;
    // The speed of the end that moved farthest in the last displacement.
    double speed_mm_per_s() const;
    // The distance from its centre to its farthest surface point.
    double reach_mm() const;
};

// A tool of one capsule, at its target.
Tool single_tool(const Capsule& shape);

// What the body and the obstacles exert on the tool.
struct ToolLoad {
    Vec3 force_un = Vec3::Zero();
    Vec3 torque_un_mm = Vec3::Zero();  // about the tool's centre
    double grip_un = 0.0;              // the lesser of the jaws' normal forces: 0 where one is free
                                       // or there are none
    Vec3 at_mm = Vec3::Zero();         // mean of its contacts, weighted by force; 0 if none
    Vec3 impulse_un_s = Vec3::Zero();  // of the body alone, over the step: sum of force times dt at
                                       // the ends of its parts
    int contacts = 0;                  // points of the body in the pad
    double least_gap_mm = std::numeric_limits<double>::max();  // to the body and to obstacles
    std::vector<int> touched;  // nodes of the triangles in the pad, each once, ascending
};

}  // namespace hepatica
