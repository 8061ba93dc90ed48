// SPDX-License-Identifier: GPL-3.0-or-later
// A tool beside a body: how it is brought to it from outside, and as it is shown.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/base/vector.h"
#include "core/deform/body/obstacles.h"
#include "core/deform/potentials/tool.h"
#include "core/scene/frame.h"

namespace hepatica {

// The tool, which is given at its destination, where it stops on its way there: it comes along
// `direction` (a unit vector) from beyond anything of the body and of the solid obstacles, and
// stops before it touches one of them. Its target is where it stops. `surface` are the body's
// triangles over positions_mm; `obstacles` may be null, and shells do not stop a tool. Only reads
// what it is given; thread-safe.
Tool brought_from_outside(Tool tool, const Vec3& direction,
                          const std::vector<std::array<int, 3>>& surface,
                          std::span<const Vec3> positions_mm, const Obstacles* obstacles);

// As it is shown, under this load.
ToolView view_of(const Tool& tool, const ToolLoad& load);

}  // namespace hepatica
