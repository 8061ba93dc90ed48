// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lesson/course_results.h"

#include <algorithm>

#include "core/base/csv_cell.h"
#include "core/base/number_text.h"
#include "core/lesson/course_standing.h"

namespace hepatica {

namespace {

LessonResult result_at(const CourseLine& lesson, const std::string& name,
                       const std::vector<Attempt>& attempts) {
    LessonResult result;
    for (const Attempt& attempt : attempts) {
        if (attempt.name != name || was_interrupted(attempt) ||
            !is_at(attempt, {lesson.id, lesson.title}))
            continue;
        ++result.attempts;
        if (!passes(attempt, lesson.pass)) continue;
        const double time_s = attempt.value(Quantity::time_s);
        result.passed = true;
        result.best_s = std::min(result.best_s.value_or(time_s), time_s);
    }
    return result;
}

}  // namespace

CourseResults results_of(const Course& course, const std::filesystem::path& folder,
                         const std::vector<Attempt>& attempts) {
    const std::vector<CourseLine> lines = standing_of(course, folder, {});
    CourseResults results;
    for (const CourseLine& line : lines) results.lessons.push_back(line.title);
    std::vector<Attempt> counted = attempts;
    std::erase_if(counted, [&](const Attempt& attempt) { return is_before(attempt, course); });
    std::vector<std::string> names = names_in(attempts);
    const bool nameless =
        std::ranges::any_of(attempts, [](const Attempt& attempt) { return attempt.name.empty(); });
    if (nameless) names.emplace_back();
    for (const std::string& name : names) {
        TraineeResults trainee{name, {}};
        for (const CourseLine& line : lines)
            trainee.lessons.push_back(result_at(line, name, counted));
        results.trainees.push_back(std::move(trainee));
    }
    return results;
}

std::string to_csv(const CourseResults& results) {
    std::string text = "name,lesson,passed,attempts,best_s\n";
    for (const TraineeResults& trainee : results.trainees)
        for (std::size_t i = 0; i < results.lessons.size(); ++i) {
            const LessonResult& result = trainee.lessons[i];
            text += csv_cell(trainee.name) + "," + csv_cell(results.lessons[i]) + "," +
                    (result.passed ? "yes" : "no") + "," + std::to_string(result.attempts) + "," +
                    (result.best_s ? number_text(*result.best_s) : "") + "\n";
        }
    return text;
}

}  // namespace hepatica
