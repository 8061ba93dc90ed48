// SPDX-License-Identifier: GPL-3.0-or-later
// JSON that people write: scripts, scenes and lessons. The JSON library takes the last of two
// values of one key in silence, as a merge by hand may leave them.
#pragma once

#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "core/base/error.h"

namespace hepatica {

// Throws InputError, whose place is the key, where an object has a key twice, and Json::exception
// (see json_problem.h) where the text is no JSON or a number is out of range.
template <class Json>
Json parse_written(const std::string& text) {
    using Event = typename Json::parse_event_t;
    std::vector<std::set<std::string>> keys;  // of each object that is not closed yet
    return Json::parse(text, [&keys](int, Event event, Json& value) {
        if (event == Event::object_start) keys.emplace_back();
        if (event == Event::object_end) keys.pop_back();
        if (event != Event::key) return true;
        const auto& key = value.template get_ref<const std::string&>();
        if (!keys.back().insert(key).second)
            throw InputError("is given twice", key, "Leave one of the two out");
        return true;
    });
}

}  // namespace hepatica
