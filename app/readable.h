// SPDX-License-Identifier: GPL-3.0-or-later
// A JSON answer in lines that a person reads.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace hepatica {

// Nested objects are indented, arrays of plain values stand on one line, arrays of equal objects
// become a table with one column per key.
std::string readable(const nlohmann::ordered_json& answer);

}  // namespace hepatica
