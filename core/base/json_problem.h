// SPDX-License-Identifier: GPL-3.0-or-later
// What is wrong with a JSON text, as a person reads it: the library's words without its numbers,
// which stand in front of them in brackets ("[json.exception.type_error.302] type must be number,
// ...").
#pragma once

#include <exception>
#include <string>

namespace hepatica {

inline std::string json_problem(const std::exception& error) {
    const std::string text = error.what();
    const std::size_t end =
        text.starts_with("[json.exception.") ? text.find("] ") : std::string::npos;
    return "is damaged (" + (end == std::string::npos ? text : text.substr(end + 2)) + ")";
}

}  // namespace hepatica
