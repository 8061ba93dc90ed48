// SPDX-License-Identifier: GPL-3.0-or-later
// What of itself and of obstacles a body touches, and what of it overlaps.
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include "core/base/vector.h"

namespace hepatica {

// At the end of a step.
struct SelfLoad {
    int contacts = 0;  // pairs of features in their pad
    double least_gap_mm = std::numeric_limits<double>::max();
};

// Of obstacles, at the end of a step.
struct ObstacleLoad {
    SelfLoad touch;
    Vec3 force_un = Vec3::Zero();      // of the body on them, friction included
    Vec3 impulse_un_s = Vec3::Zero();  // over the step: forces at the ends of its parts times dt
};

// What finding contacts costs: searches, nearest points and times of contact.
struct SelfCost {
    std::size_t bytes = 0;
    double build_ms = 0.0, step_ms = 0.0;
};

// What overlaps, as pairs one after the other: see Overlaps.
struct OverlapsKept {
    std::vector<int> touching, buried;
};

// Of all surfaces that a body touches with; none where it does not.
struct SurfacesKept {
    std::optional<OverlapsKept> self, obstacles;
};

}  // namespace hepatica
