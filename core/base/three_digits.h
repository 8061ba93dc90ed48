// SPDX-License-Identifier: GPL-3.0-or-later
// The rounding of measured values that are shown, so that the same one reads the same wherever it
// stands: no more than three significant digits before the decimal sign.
#pragma once

#include <cmath>

namespace hepatica {

// 1151.3 becomes 1150, 999.6 becomes 1000; what is below 999.5 keeps all its digits.
inline double in_three_digits(double value) {
    if (!std::isfinite(value) || std::abs(value) < 999.5) return value;
    const double finest = std::pow(10.0, std::floor(std::log10(std::abs(value))) - 2.0);
    return std::abs(value) < 1000.0 ? std::copysign(1000.0, value)
                                    : finest * std::round(value / finest);
}

}  // namespace hepatica
