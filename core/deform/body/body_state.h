// SPDX-License-Identifier: GPL-3.0-or-later
// Positions and velocities of the nodes of a body.
#pragma once

#include <vector>

#include "core/base/vector.h"

namespace hepatica {

// One entry per node of a Body, or one per vertex of the mesh where only vertices are known.
struct BodyState {
    std::vector<Vec3> positions_mm;
    std::vector<Vec3> velocities_mm_per_s;
};

}  // namespace hepatica
