// SPDX-License-Identifier: GPL-3.0-or-later
// Times of repeated work, for the benchmarks.
#pragma once

#include <algorithm>
#include <chrono>
#include <vector>

namespace hepatica {

// Wall-clock time of one call.
template <class Work>
double timed_ms(const Work& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
        .count();
}

// The value that `share` of the values are below; 0.5 is the median: neither a cold first call nor
// a disturbed one counts. At least one value.
inline double quantile(std::vector<double> values, double share) {
    const auto place = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), values.begin() + place, values.end());
    return values[static_cast<std::size_t>(place)];
}

}  // namespace hepatica
