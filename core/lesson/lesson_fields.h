// SPDX-License-Identifier: GPL-3.0-or-later
// Typed access to one JSON value of a lesson's file. Errors name the file and the place in it.
#pragma once

#include <initializer_list>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "core/base/vector.h"

namespace hepatica {

// What the user can do about a lesson that cannot be read.
inline constexpr const char* lesson_remedy =
    "See docs/lessons.md, and assets/lessons for lessons that work";

// A view: the JSON must outlive it. Every accessor throws InputError where the value has another
// type.
class LessonFields {
  public:
    using Json = nlohmann::ordered_json;

    // `where`: place in the file; empty: the whole file. `unfinished`: the lesson is being edited,
    // and texts may be empty.
    LessonFields(const Json& json, std::string file, std::string where, bool unfinished = false)
        : json_(json), file_(std::move(file)), where_(std::move(where)), unfinished_(unfinished) {}
    bool unfinished() const { return unfinished_; }

    // --- of an object
    bool has(const char* key) const;
    LessonFields need(const char* key) const;
    std::vector<std::pair<std::string, LessonFields>> entries() const;
    // Throws for any other key, so that a misspelt one is not ignored. `by_program`: one that is
    // read, too, but that no person is to write, so that nobody is told to choose it.
    void know(std::initializer_list<const char*> keys, const char* by_program = nullptr) const;

    // Throws unless the file has {"format": `format`, "version": 1}.
    void require_format(const char* format, const char* remedy) const;
    // --- of a list
    std::vector<LessonFields> list() const;

    // --- of a value
    std::string text() const;  // not empty unless unfinished()
    double number() const;     // finite
    Vec3 vector() const;
    std::string dump() const { return json_.dump(); }
    const Json& json() const { return json_; }

    std::string place() const { return where_.empty() ? file_ : file_ + ": " + where_; }
    [[noreturn]] void refuse(const std::string& problem, const std::string& remedy) const;

  private:
    const Json& json_;
    std::string file_;
    std::string where_;
    bool unfinished_;
};

}  // namespace hepatica
