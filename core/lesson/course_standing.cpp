// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lesson/course_standing.h"

#include <algorithm>

namespace hepatica {

namespace {

// The id of a lesson that comes with the program, or a file beside the course.
std::string name_of(const std::string& entry, const std::filesystem::path& folder) {
    const auto lessons = built_in_lessons();
    const bool built_in = std::ranges::any_of(
        lessons, [&](const BuiltInLesson& lesson) { return entry == lesson.id; });
    return built_in ? entry : (folder / entry).string();
}

}  // namespace

bool passes(const Attempt& attempt, const std::vector<Predicate>& marks) {
    return attempt.passed && std::ranges::all_of(marks, [&](const Predicate& mark) {
               return mark.quantity < Quantity::step_time_s &&
                      mark.holds(attempt.value(mark.quantity));
           });
}

std::vector<CourseLine> standing_of(const Course& course, const std::filesystem::path& folder,
                                    const std::vector<Attempt>& attempts) {
    std::vector<CourseLine> lines;
    for (const CourseEntry& entry : course.lessons) {
        CourseLine line{name_of(entry.lesson, folder), "", entry.pass, 0, false};
        line.title = find_lesson(line.lesson).name;
        for (const Attempt& attempt : attempts) {
            if (attempt.lesson != line.title) continue;
            ++line.attempts;
            line.passed = line.passed || passes(attempt, entry.pass);
        }
        lines.push_back(std::move(line));
    }
    return lines;
}

}  // namespace hepatica
