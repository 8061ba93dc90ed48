// SPDX-License-Identifier: GPL-3.0-or-later
// Who passed what: all trainees by the lessons of a course, from the attempts that are kept.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/lesson/attempts.h"
#include "core/lesson/lesson_file.h"

namespace hepatica {

struct LessonResult {
    int attempts = 0;
    bool passed = false;
    std::optional<double> best_s;  // the shortest time of those that passed
    bool operator==(const LessonResult&) const = default;
};

struct TraineeResults {
    std::string name;                   // empty: those who gave none
    std::vector<LessonResult> lessons;  // one for each of the course
};

struct CourseResults {
    std::vector<std::string> lessons;      // titles
    std::vector<TraineeResults> trainees;  // by name, the nameless last
};

// With the course's own pass marks. Throws InputError where a lesson cannot be read.
CourseResults results_of(const Course& course, const std::filesystem::path& folder,
                         const std::vector<Attempt>& attempts);

// "name,lesson,passed,attempts,best_s" and a row for each trainee and lesson.
std::string to_csv(const CourseResults& results);

}  // namespace hepatica
