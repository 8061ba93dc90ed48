// SPDX-License-Identifier: GPL-3.0-or-later
// A closed range of numbers, and what is said of a number outside of it.
#pragma once

#include <string>

#include "core/base/number_text.h"

namespace hepatica {

struct NumberRange {
    double low;
    double high;

    // False for NaN.
    bool holds(double value) const { return value >= low && value <= high; }
};

// The problem of a value outside: "is 2; it must lie from 0 to 1".
inline std::string outside(double value, const NumberRange& range) {
    return "is " + number_text(value) + "; it must lie from " + number_text(range.low) + " to " +
           number_text(range.high);
}

}  // namespace hepatica
