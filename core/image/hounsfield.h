// SPDX-License-Identifier: GPL-3.0-or-later
// Hounsfield units as the voxels of a CT hold them, in 16 bits, and what is said of values that do
// not fit.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>

namespace hepatica {

inline constexpr double least_hounsfield = std::numeric_limits<std::int16_t>::min();
inline constexpr double largest_hounsfield = std::numeric_limits<std::int16_t>::max();

inline bool fits_hounsfield(double value) {
    return value >= least_hounsfield && value <= largest_hounsfield;
}

// The nearest one; the value must be a number.
inline std::int16_t nearest_hounsfield(double value) {
    return static_cast<std::int16_t>(
        std::lround(std::clamp(value, least_hounsfield, largest_hounsfield)));
}

inline std::string remark_on_clamped(std::size_t values) {
    return std::to_string(values) + " values lie outside 16 bits and were clamped";
}

}  // namespace hepatica
