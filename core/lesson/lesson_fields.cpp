// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lesson/lesson_fields.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"

namespace hepatica {

void LessonFields::refuse(const std::string& problem, const std::string& remedy) const {
    throw InputError(problem, place(), remedy);
}

bool LessonFields::has(const char* key) const {
    if (!json_.is_object()) refuse("is not an object", "Write it as {\"...\": ...}");
    return json_.contains(key);
}

LessonFields LessonFields::need(const char* key) const {
    if (!has(key)) refuse("has no \"" + std::string(key) + "\"", "Add it: see docs/lessons.md");
    return {json_[key], file_, where_.empty() ? key : where_ + "." + key, unfinished_};
}

std::vector<std::pair<std::string, LessonFields>> LessonFields::entries() const {
    std::vector<std::pair<std::string, LessonFields>> found;
    if (!json_.is_object()) refuse("is not an object", "Write it as {\"...\": ...}");
    for (const auto& [key, value] : json_.items()) found.emplace_back(key, need(key.c_str()));
    return found;
}

void LessonFields::know(std::initializer_list<const char*> keys, const char* by_program) const {
    std::string known;
    for (const char* key : keys) known += (known.empty() ? "" : ", ") + std::string(key);
    for (const auto& [key, field] : entries())
        if (std::ranges::find(keys, key) == keys.end() &&
            (by_program == nullptr || key != by_program))
            field.refuse("is not known", "Choose from " + known);
}

void LessonFields::require_format(const char* format, const char* remedy) const {
    const LessonFields name = need("format");
    if (name.text() != format)
        name.refuse("is \"" + name.text() + "\", not \"" + format + "\"", remedy);
    const LessonFields version = need("version");
    if (version.number() != 1.0)
        version.refuse("is " + version.dump() + ", and this program reads 1",
                       "Take a newer program, or write the file for version 1");
}

std::vector<LessonFields> LessonFields::list() const {
    if (!json_.is_array()) refuse("is " + dump() + ", not a list", "Write it as [...]");
    std::vector<LessonFields> found;
    for (std::size_t i = 0; i < json_.size(); ++i)
        found.emplace_back(json_[i], file_, where_ + "[" + std::to_string(i) + "]", unfinished_);
    return found;
}

std::string LessonFields::text() const {
    if (!json_.is_string() || (json_.get<std::string>().empty() && !unfinished_))
        refuse("is " + dump() + ", not a text", "Write it as \"...\"");
    return json_.get<std::string>();
}

double LessonFields::number() const {
    if (!json_.is_number() || !std::isfinite(json_.get<double>()))
        refuse("is " + dump() + ", not a number", "Give a number");
    return json_.get<double>();
}

Vec3 LessonFields::vector() const {
    const std::vector<LessonFields> numbers = list();
    if (numbers.size() != 3) refuse("is " + dump() + ", not a place", "Give three numbers, in mm");
    return {numbers[0].number(), numbers[1].number(), numbers[2].number()};
}

}  // namespace hepatica
