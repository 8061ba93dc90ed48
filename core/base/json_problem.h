// SPDX-License-Identifier: GPL-3.0-or-later
// The problem of a JSON text for the user: the library's message without its prefix
// ("[json.exception.type_error.302] type must be number, ...").
#pragma once

#include <exception>
#include <string>

namespace hepatica {

inline std::string message_of_json(const std::exception& error) {
    const std::string text = error.what();
    const std::size_t end =
        text.starts_with("[json.exception.") ? text.find("] ") : std::string::npos;
    return end == std::string::npos ? text : text.substr(end + 2);
}

inline std::string json_problem(const std::exception& error) {
    return "is damaged (" + message_of_json(error) + ")";
}

}  // namespace hepatica
