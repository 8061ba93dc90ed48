// SPDX-License-Identifier: GPL-3.0-or-later
// What of itself a body touches, and what of it overlaps.
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

namespace hepatica {

// At the end of a step.
struct SelfLoad {
    int contacts = 0;  // pairs of features in their pad
    double least_gap_mm = std::numeric_limits<double>::max();
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

}  // namespace hepatica
