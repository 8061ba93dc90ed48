// SPDX-License-Identifier: GPL-3.0-or-later
// Formats a JSON answer as lines for people.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace hepatica {

// Nested objects are indented, arrays of plain values are on one line, and arrays of objects become
// a table with a column per key of the first.
std::string readable(const nlohmann::ordered_json& answer);

}  // namespace hepatica
