// SPDX-License-Identifier: GPL-3.0-or-later
// A compliant pull: a spring of limited force between a point of the body and a target. It never
// prescribes a position, so that no speed of the mouse makes the simulation unstable.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "core/base/vector.h"

namespace hepatica {

struct Grab {
    std::array<int, 4> vertices{-1, -1, -1, -1};  // the held point is their weighted mean
    std::array<double, 4> weights{1, 0, 0, 0};    // sum 1
    Vec3 target_mm = Vec3::Zero();
    double stiffness_un_per_mm = 0.0;  // micronewton per millimetre, > 0
    double force_limit_un = 0.0;       // micronewton, > 0
};

// Whether it holds a vertex that a body of so many nodes does not have.
inline bool holds_beyond(const Grab& grab, std::size_t nodes) {
    return std::ranges::any_of(grab.vertices,
                               [nodes](int v) { return v >= static_cast<int>(nodes); });
}

}  // namespace hepatica
