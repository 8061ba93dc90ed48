// SPDX-License-Identifier: GPL-3.0-or-later
// Cells of a table of comma-separated values (RFC 4180).
#pragma once

#include <charconv>
#include <cmath>
#include <string>

namespace hepatica {

// As a cell of a table, whatever is in it.
inline std::string csv_cell(const std::string& text) {
    std::string quoted = "\"";
    for (const char letter : text) quoted += letter == '"' ? "\"\"" : std::string(1, letter);
    return quoted + "\"";
}

// With all digits; empty where it is not known.
inline std::string csv_cell(double value) {
    char text[40];
    return std::isfinite(value) ? std::string(text, std::to_chars(text, text + 40, value).ptr) : "";
}

}  // namespace hepatica
