// SPDX-License-Identifier: GPL-3.0-or-later
// Results of all trainees in the lessons of a course, computed from their stored attempts.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/lesson/attempts.h"
#include "core/lesson/lesson_file.h"

namespace hepatica {

struct LessonResult {
    int attempts = 0;  // without interrupted ones
    bool passed = false;
    std::optional<double> best_s;  // shortest time of a passed attempt
    bool operator==(const LessonResult&) const = default;
};

struct TraineeResults {
    std::string name;                   // empty: attempts without a name
    std::vector<LessonResult> lessons;  // as in CourseResults::lessons
};

struct CourseResults {
    std::vector<std::string> lessons;      // titles
    std::vector<TraineeResults> trainees;  // sorted by name, the nameless last
};

// Includes the course's own pass marks; attempts from before the course was made do not count.
// `folder`: where the course's file lies. Throws InputError where a lesson cannot be read.
CourseResults results_of(const Course& course, const std::filesystem::path& folder,
                         const std::vector<Attempt>& attempts);

// CSV: "name,lesson,passed,attempts,best_s" and a row for each trainee and lesson.
std::string to_csv(const CourseResults& results);

}  // namespace hepatica
