// SPDX-License-Identifier: GPL-3.0-or-later
// Length of centrelines that other centrelines have found, by the radius of the vessel.
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "core/accuracy/centreline_samples.h"
#include "core/tree/extraction/centreline_locator.h"

namespace hepatica {

inline constexpr std::array radius_class_borders_mm{1.0, 1.5, 2.5};

struct FoundLength {
    double found_mm = 0.0, all_mm = 0.0;

    void add(double length_mm, bool is_found) {
        all_mm += length_mm;
        if (is_found) found_mm += length_mm;
    }
    double share() const { return all_mm > 0.0 ? found_mm / all_mm : 0.0; }
};

// One for each class of radii: below the first border, between two borders, from the last one on.
using FoundLengths = std::array<FoundLength, radius_class_borders_mm.size() + 1>;

FoundLength sum(const FoundLengths& lengths);

// Sums the judged samples for which `wanted` holds; a sample is found where one of `others` lies
// within tolerance_mm.
FoundLengths found_lengths(const CentrelineSamples& line,
                           const std::function<bool(const CentrelineSample&)>& wanted,
                           const std::vector<const CentrelineLocator*>& others,
                           double tolerance_mm);

}  // namespace hepatica
