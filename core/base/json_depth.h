// SPDX-License-Identifier: GPL-3.0-or-later
// How deep the lists and objects of a JSON text are nested. The JSON library parses any depth but
// copies and writes values by recursion, so that a hostile text could overflow the stack.
#pragma once

#include <string_view>

namespace hepatica {

// Far more than any file of this program has.
inline constexpr int deepest_json = 100;

// Whether lists and objects are nested deeper than deepest_json, whatever else the text holds.
inline bool nests_too_deep(std::string_view json) {
    int depth = 0;
    bool quoted = false, escaped = false;
    for (const char letter : json) {
        if (escaped)
            escaped = false;
        else if (quoted && letter == '\\')
            escaped = true;
        else if (letter == '"')
            quoted = !quoted;
        else if (!quoted && (letter == '[' || letter == '{') && ++depth > deepest_json)
            return true;
        else if (!quoted && (letter == ']' || letter == '}'))
            --depth;
    }
    return false;
}

}  // namespace hepatica
