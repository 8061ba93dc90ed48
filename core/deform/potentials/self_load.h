// SPDX-License-Identifier: GPL-3.0-or-later
// What a body touches (itself, obstacles) and what of its surfaces overlaps.
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include "core/base/vector.h"

namespace hepatica {

// Contacts at the end of a step.
struct SelfLoad {
    int contacts = 0;  // pairs of features in their pad
    double least_gap_mm = std::numeric_limits<double>::max();
};

// Contact with obstacles at the end of a step.
struct ObstacleLoad {
    SelfLoad touch;
    Vec3 force_un = Vec3::Zero();      // on the obstacles, friction included
    Vec3 impulse_un_s = Vec3::Zero();  // sum of force times dt over the step's parts
};

// Cost of finding contacts: searches, nearest points and times of contact.
struct SelfCost {
    std::size_t bytes = 0;
    double build_ms = 0.0, step_ms = 0.0;
};

// Overlapping pairs, their two numbers one after the other: see Overlaps.
struct OverlapsKept {
    std::vector<int> touching, buried;
};

// Overlaps of all surfaces that a body touches with; empty where it does not.
struct SurfacesKept {
    std::optional<OverlapsKept> self, obstacles;
};

}  // namespace hepatica
