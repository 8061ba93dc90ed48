// SPDX-License-Identifier: GPL-3.0-or-later
// Roman names of Couinaud's segments, I to VIII. Files keep the numbers 1 to 8.
#pragma once

#include <array>
#include <string>

namespace hepatica {

// The name of segment 1 to 8; empty for other numbers.
inline std::string segment_name(int segment) {
    constexpr std::array names{"I", "II", "III", "IV", "V", "VI", "VII", "VIII"};
    const bool known = segment >= 1 && segment <= static_cast<int>(names.size());
    return known ? names[static_cast<std::size_t>(segment - 1)] : "";
}

}  // namespace hepatica
