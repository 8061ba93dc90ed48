// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers in messages, with a decimal point in every locale.
#pragma once

#include <array>
#include <charconv>
#include <string>

namespace hepatica {

// With six significant digits.
inline std::string number_text(double value) {
    std::array<char, 32> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value,
                                   std::chars_format::general, 6);
    return {digits.data(), end.ptr};
}

// With the given number of decimals (0 to 15), rounded to nearest; a zero has no sign.
inline std::string fixed_text(double value, int decimals) {
    std::array<char, 384> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value,
                                   std::chars_format::fixed, decimals);
    const std::string text(digits.data(), end.ptr);
    return text.find_first_of("123456789") == std::string::npos && text.starts_with('-')
               ? text.substr(1)
               : text;
}

}  // namespace hepatica
