// SPDX-License-Identifier: GPL-3.0-or-later
// How a tool goes where it is led, past surfaces that stand still: along its way and sliding on
// what stops it, then about its centre, then its jaws; each until a gap falls to what is to be kept
// or the body pushes back with the tool's limit of force. A turn is swept in small parts, in each
// of which the ends go straight: between arc and chord there is a fortieth of the gap at most.
#pragma once

#include <functional>
#include <span>

#include "core/deform/potentials/tool.h"

namespace hepatica {

// What body and obstacles would do to the tool if its parts stood there.
struct ToolResistance {
    Vec3 force_un = Vec3::Zero();
    Vec3 torque_un_mm = Vec3::Zero();  // about the centre
    double grip_un = 0.0;              // against closing
    bool closed = false;               // a gap of the pad has closed: it must not stand there
};
using ResistanceAt = std::function<ToolResistance(std::span<const Capsule>)>;

// Leads the tool over dt_s > 0 by `share` (0 to 1) of all that it has still to go, and keeps a gap
// of keep_mm > 0. Returns whether it moved.
bool lead(Tool& tool, const StandingSurfaces& surfaces, double keep_mm, double share, double dt_s,
          const ResistanceAt& resistance);

// What is left to turn, once `by_rad` is to be turned after `left_rad`: one vector for both.
Vec3 turned_after(const Vec3& left_rad, const Vec3& by_rad);

}  // namespace hepatica
