// SPDX-License-Identifier: GPL-3.0-or-later
// JSON that people write: scripts, scenes, lessons and lists of edits. The JSON library takes the
// last of two values of one key in silence, as a merge by hand may leave them, and names no line
// for a number that is too large.
#pragma once

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/base/json_problem.h"

namespace hepatica {

// A number that no double holds, told like the library's other faults of a text.
template <class Json>
class NumberTooLarge : public Json::exception {
  public:
    // `read` is the text up to the number's last digit.
    NumberTooLarge(std::string_view read, const std::string& problem)
        : Json::exception(406, said_of(read, problem).c_str()) {}

  private:
    static std::string said_of(std::string_view read, const std::string& problem) {
        const auto line = 1 + std::ranges::count(read, '\n');
        const std::size_t column = read.size() - (read.rfind('\n') + 1);  // npos + 1 is 0
        return "parse error at line " + std::to_string(line) + ", column " +
               std::to_string(column) + ": " + problem;
    }
};

// Throws InputError, whose place is the key, where an object has a key twice, and Json::exception
// (see json_problem.h) with line and column where the text is no JSON or a number is out of range.
template <class Json>
Json parse_written(const std::string& text) {
    using Event = typename Json::parse_event_t;
    std::vector<std::set<std::string>> keys;  // of each object that is not closed yet
    const auto judge = [&keys](int, Event event, Json& value) {
        if (event == Event::object_start) keys.emplace_back();
        if (event == Event::object_end) keys.pop_back();
        if (event != Event::key) return true;
        const auto& key = value.template get_ref<const std::string&>();
        if (!keys.back().insert(key).second)
            throw InputError("is given twice", key, "Leave one of the two out");
        return true;
    };
    std::istringstream in(text);  // tells how far it was read
    try {
        return Json::parse(in, judge);
    } catch (const typename Json::out_of_range& error) {
        const auto position = in.rdbuf()->pubseekoff(0, std::ios::cur, std::ios::in);
        const auto read = static_cast<std::size_t>(position) - (in.eof() ? 0 : 1);  // one behind it
        throw NumberTooLarge<Json>(std::string_view(text).substr(0, read), message_of_json(error));
    }
}

}  // namespace hepatica
