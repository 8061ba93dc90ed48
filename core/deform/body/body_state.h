// SPDX-License-Identifier: GPL-3.0-or-later
// Where the nodes of a body are and how fast they move.
#pragma once

#include <vector>

#include "core/base/vector.h"

namespace hepatica {

// One entry per node of a Body each, or one per vertex where that is all there is.
struct BodyState {
    std::vector<Vec3> positions_mm;
    std::vector<Vec3> velocities_mm_per_s;
};

}  // namespace hepatica
