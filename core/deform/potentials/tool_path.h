// SPDX-License-Identifier: GPL-3.0-or-later
// Moves a tool towards its target past fixed surfaces: first the centre, sliding along what stops
// it, then the rotation, then the jaws. Each goes on until a gap falls to what must be kept or the
// body pushes back with the tool's force limit. A rotation is swept in small increments along
// straight lines; arc and chord differ by at most a fortieth of the kept gap.
#pragma once

#include <functional>
#include <span>

#include "core/deform/potentials/tool.h"

namespace hepatica {

// What body and obstacles would exert on the tool if its parts had these shapes.
struct ToolResistance {
    Vec3 force_un = Vec3::Zero();
    Vec3 torque_un_mm = Vec3::Zero();  // about the centre
    double grip_un = 0.0;              // against closing the jaws
    double held_un = 0.0;              // the least force that presses a jaw outwards; 0: none held
    bool closed = false;               // a gap is closed: the tool must not be there
};
using ResistanceAt = std::function<ToolResistance(std::span<const Capsule>)>;

// Moves the tool over dt_s > 0 by `share` (0 to 1) of its remaining way and keeps a gap of keep_mm
// > 0. Returns whether it moved.
bool lead(Tool& tool, const StandingSurfaces& surfaces, double keep_mm, double share, double dt_s,
          const ResistanceAt& resistance);

// The remaining rotation vector once the rotation `by_rad` is appended to `left_rad`.
Vec3 turned_after(const Vec3& left_rad, const Vec3& by_rad);

}  // namespace hepatica
