// SPDX-License-Identifier: GPL-3.0-or-later
// What a body touches (itself, obstacles) and what of its surfaces overlaps.
#pragma once

#include <array>
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

// The pad of two features that a split changed: see pair_pads.h.
struct PairPad {
    std::array<int, 4> nodes{};  // of both features, in the order of pair_pads.h
    int in_first = 1;            // nodes of the first feature: 1 (vertex and triangle) or 2 (edges)
    double pad_mm = 0.0;         // its thickness, > 0
    double most_mm = 0.0;        // the thickness that it would have otherwise, >= pad_mm
    double share = 1.0;          // of the area that it would have otherwise, in (0, 1]
};

// Overlapping pairs, see Overlaps, and twins that lie on each other, see TornSides, their two
// numbers one after the other. Pads that a split changed, ascending.
struct OverlapsKept {
    std::vector<int> touching, buried;
    std::vector<int> lying{};
    std::vector<PairPad> pads{};
};

// Overlaps of all surfaces that a body touches with; empty where it does not.
struct SurfacesKept {
    std::optional<OverlapsKept> self, obstacles;
};

}  // namespace hepatica
