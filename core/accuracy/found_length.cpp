// SPDX-License-Identifier: GPL-3.0-or-later
// Sums found lengths by class of radius.
#include "core/accuracy/found_length.h"

#include <algorithm>

namespace hepatica {

FoundLength sum(const FoundLengths& lengths) {
    FoundLength all;
    for (const FoundLength& length : lengths) {
        all.found_mm += length.found_mm;
        all.all_mm += length.all_mm;
    }
    return all;
}

FoundLengths found_lengths(const CentrelineSamples& line,
                           const std::function<bool(const CentrelineSample&)>& wanted,
                           const std::vector<const CentrelineLocator*>& others,
                           double tolerance_mm) {
    FoundLengths lengths;
    for (const CentrelineSample& sample : line.samples) {
        if (!sample.judged || !wanted(sample)) continue;
        const bool found = std::ranges::any_of(others, [&](const CentrelineLocator* other) {
            return other->nearest(sample.position_mm, tolerance_mm).has_value();
        });
        const auto size = std::ranges::upper_bound(radius_class_borders_mm, sample.radius_mm);
        lengths[size - radius_class_borders_mm.begin()].add(sample.weight_mm, found);
    }
    return lengths;
}

}  // namespace hepatica
