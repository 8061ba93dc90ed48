// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lesson/course_standing.h"

#include <algorithm>

namespace hepatica {

std::string lesson_named_by(const std::string& entry, const std::filesystem::path& folder) {
    return built_in_lesson(entry) ? entry : (folder / entry).lexically_normal().string();
}

std::string entry_naming(const std::string& lesson, const std::filesystem::path& folder) {
    if (built_in_lesson(lesson)) return lesson;
    return std::filesystem::path(lesson)
        .lexically_normal()
        .lexically_proximate(folder.lexically_normal())
        .string();
}

bool passes(const Attempt& attempt, const std::vector<Predicate>& marks) {
    return attempt.passed_lesson && std::ranges::all_of(marks, [&](const Predicate& mark) {
               if (mark.quantity < Quantity::step_time_s)
                   return mark.holds(attempt.value(mark.quantity));
               // No result keeps it: it was judged when the attempt ended.
               return attempt.passed &&
                      std::ranges::find(attempt.course_pass, mark) != attempt.course_pass.end();
           });
}

bool is_before(const Attempt& attempt, const Course& course) {
    return attempt.ended_at < course.made_at;
}

std::vector<CourseLine> standing_of(const Course& course, const std::filesystem::path& folder,
                                    const std::vector<Attempt>& attempts) {
    std::vector<CourseLine> lines;
    for (const CourseEntry& entry : course.lessons) {
        CourseLine line{lesson_named_by(entry.lesson, folder), "", entry.pass, 0, false};
        const Lesson lesson = find_lesson(line.lesson);
        line.title = lesson.name;
        line.id = lesson.id;
        // Who passed the lesson has met the marks that it has itself.
        std::erase_if(line.pass, [&](const Predicate& mark) {
            return std::ranges::find(lesson.pass, mark) != lesson.pass.end();
        });
        for (const Attempt& attempt : attempts) {
            if (was_interrupted(attempt) || !is_at(attempt, {line.id, line.title})) continue;
            const bool earlier = is_before(attempt, course);
            if (!earlier) ++line.attempts;
            bool& passed = earlier ? line.passed_earlier : line.passed;
            passed = passed || passes(attempt, line.pass);
        }
        lines.push_back(std::move(line));
    }
    return lines;
}

}  // namespace hepatica
