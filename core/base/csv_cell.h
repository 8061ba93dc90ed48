// SPDX-License-Identifier: GPL-3.0-or-later
// Cells of comma-separated values (RFC 4180).
#pragma once

#include <charconv>
#include <cmath>
#include <string>

namespace hepatica {

// A quoted cell; quotes inside are doubled.
inline std::string csv_cell(const std::string& text) {
    std::string quoted = "\"";
    for (const char letter : text) quoted += letter == '"' ? "\"\"" : std::string(1, letter);
    return quoted + "\"";
}

// The shortest text that reads back as the same number; empty if it is not finite.
inline std::string csv_cell(double value) {
    char text[40];
    return std::isfinite(value) ? std::string(text, std::to_chars(text, text + 40, value).ptr) : "";
}

}  // namespace hepatica
