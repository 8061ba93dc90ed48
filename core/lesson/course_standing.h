// SPDX-License-Identifier: GPL-3.0-or-later
// Progress in a course: which of its lessons the attempts have passed, including the course's own
// pass marks.
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
    std::vector<Predicate> pass;  // the course's, in addition to the lesson's
    int attempts = 0;             // those that count
    bool passed = false;          // by one that counts
    std::string id{};             // of the lesson, see LessonKey; may be empty
    bool passed_earlier = false;  // by one from before the course was made
};

// The lesson of a course's entry, as find_lesson() takes it: the id of a built-in lesson, or the
// path of a file, resolved against the course's folder.
std::string lesson_named_by(const std::string& entry, const std::filesystem::path& folder);
// The inverse: the entry for a lesson in a course in this folder.
std::string entry_naming(const std::string& lesson, const std::filesystem::path& folder);

// Returns true if the attempt passed the lesson and meets these marks. Unknown quantities meet
// none; those of a moment only the marks of the course that the attempt passed.
bool passes(const Attempt& attempt, const std::vector<Predicate>& marks);

// Returns true for attempts that ended before the course was made: they were not made for it.
bool is_before(const Attempt& attempt, const Course& course);

// One line per lesson, in order. Interrupted attempts and those before the course do not count.
// `folder`: where the course's file lies. Throws InputError where a lesson cannot be read.
std::vector<CourseLine> standing_of(const Course& course, const std::filesystem::path& folder,
                                    const std::vector<Attempt>& attempts);

}  // namespace hepatica
