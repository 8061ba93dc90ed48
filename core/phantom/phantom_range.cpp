// SPDX-License-Identifier: GPL-3.0-or-later
// Implements the range check of phantom options.
#include "core/phantom/phantom_range.h"

#include "core/base/error.h"

namespace hepatica {

void require_range(const std::string& name, double value, double low, double high) {
    if (value >= low && value <= high) return;
    const auto text = [](double number) {
        std::string digits = std::to_string(number);
        digits.erase(digits.find_last_not_of('0') + 1);
        return digits.ends_with('.') ? digits.substr(0, digits.size() - 1) : digits;
    };
    throw InputError(text(value) + " cannot be used", name,
                     "Choose a value from " + text(low) + " to " + text(high));
}

}  // namespace hepatica
