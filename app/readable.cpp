// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/readable.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

namespace hepatica {

namespace {

using Json = nlohmann::ordered_json;

std::string plain(const Json& value) {
    if (value.is_string()) return value.get<std::string>();
    // JSON has no other number either: it says null.
    if (value.is_null() || (value.is_number_float() && !std::isfinite(value.get<double>())))
        return "none";
    if (value.is_boolean()) return value.get<bool>() ? "yes" : "no";
    if (value.is_number_float()) {
        char text[32];
        std::snprintf(text, sizeof text, "%.5g", value.get<double>());
        return text;
    }
    return value.dump();
}

std::string plain_list(const Json& list) {
    std::string text;
    for (const Json& value : list) {
        if (!text.empty()) text += ", ";
        text += value.is_array() ? "(" + plain_list(value) + ")" : plain(value);
    }
    return text;
}

bool is_list_of_objects(const Json& value) {
    return value.is_array() && !value.empty() &&
           std::ranges::all_of(value, [](const Json& row) { return row.is_object(); });
}

std::string padded(std::string text, std::size_t width) {
    text.resize(std::max(width, text.size()), ' ');
    return text;
}

std::string table(const Json& rows, const std::string& indent) {
    std::vector<std::string> names;
    for (const auto& [name, value] : rows.front().items()) names.push_back(name);
    std::vector<std::vector<std::string>> lines{names};
    for (const Json& row : rows) {
        std::vector<std::string> line;
        for (const std::string& name : names)
            line.push_back(!row.contains(name)         ? ""
                           : row[name].is_structured() ? plain_list(row[name])
                                                       : plain(row[name]));
        lines.push_back(std::move(line));
    }
    std::vector<std::size_t> widths(names.size(), 0);
    for (const auto& line : lines)
        for (std::size_t i = 0; i < line.size(); ++i)
            widths[i] = std::max(widths[i], line[i].size());
    std::string text;
    for (const auto& line : lines) {
        text += indent;
        for (std::size_t i = 0; i < line.size(); ++i)
            text += i + 1 < line.size() ? padded(line[i], widths[i] + 2) : line[i];
        text += "\n";
    }
    return text;
}

std::string object(const Json& answer, const std::string& indent) {
    std::string text;
    for (const auto& [name, value] : answer.items()) {
        if (value.is_object())
            text += indent + name + "\n" + object(value, indent + "  ");
        else if (is_list_of_objects(value))
            text += indent + name + "\n" + table(value, indent + "  ");
        else
            text += indent + padded(name, 24) + " " +
                    (value.is_array() ? plain_list(value) : plain(value)) + "\n";
    }
    return text;
}

}  // namespace

std::string readable(const Json& answer) {
    return answer.is_object() ? object(answer, "") : plain(answer) + "\n";
}

}  // namespace hepatica
