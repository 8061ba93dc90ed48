// SPDX-License-Identifier: GPL-3.0-or-later
// Quotes a text as a cell of a CSV table (RFC 4180).
#pragma once

#include <string>

namespace hepatica {

inline std::string csv_cell(const std::string& text) {
    std::string cell = "\"";
    for (const char c : text) cell += c == '"' ? std::string("\"\"") : std::string(1, c);
    return cell + "\"";
}

}  // namespace hepatica
