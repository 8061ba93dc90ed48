// SPDX-License-Identifier: GPL-3.0-or-later
// How far somebody has come in a course: which of its lessons one of his attempts has passed, the
// course's own pass marks included.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/lesson/attempts.h"
#include "core/lesson/lesson_file.h"

namespace hepatica {

struct CourseLine {
    std::string lesson;  // as find_lesson() takes it
    std::string title;
    std::vector<Predicate> pass;  // of the course, beside the lesson's own
    int attempts = 0;
    bool passed = false;
};

// What an entry of a course in this folder names, as find_lesson() takes it: the id of a lesson
// that comes with the program, or a file relative to the folder.
std::string lesson_named_by(const std::string& entry, const std::filesystem::path& folder);
// Back again: how a course in this folder names a lesson.
std::string entry_naming(const std::string& lesson, const std::filesystem::path& folder);

// An attempt that passed the lesson and meets these marks. A quantity that is not known meets none.
bool passes(const Attempt& attempt, const std::vector<Predicate>& marks);

// A line for each lesson of the course, in its order. Lessons that are files lie relative to
// `folder`. Throws InputError where a lesson cannot be read.
std::vector<CourseLine> standing_of(const Course& course, const std::filesystem::path& folder,
                                    const std::vector<Attempt>& attempts);

}  // namespace hepatica
