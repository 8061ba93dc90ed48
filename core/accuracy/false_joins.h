// SPDX-License-Identifier: GPL-3.0-or-later
// Counts the places at which a tree connects vessels that the truth keeps apart.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/accuracy/centreline_samples.h"

namespace hepatica {

struct JoinOptions {
    // A stretch along one system that is shorter than this is ignored: a centreline may stray that
    // far where lumens touch, and a tree that was opened there keeps a stub.
    double stray_mm = usual_stray_mm;
    // Joins count as one place where they are closer along the tree than the lumen's radius plus
    // this, as the two sides of a crossing are.
    double place_mm = 2.0;
};

// Number of places where a connected piece of the judged samples runs from one true system to
// another, directly or through stretches near no truth. `truth` holds the true system of each
// sample, 0 where it is near none. O(n log n) for n samples.
int count_false_joins(const CentrelineSamples& tree, std::span<const std::uint8_t> truth,
                      const JoinOptions& options = {});

}  // namespace hepatica
