// SPDX-License-Identifier: GPL-3.0-or-later
// The results of attempts at lessons, each in a small file beside its recording
// (NAME.result.json beside NAME.hrec), for a learning curve and for comparing with an instructor.
//   {"format": "hepatica-result", "version": 1, "lesson": "Gentle pull",
//    "ended_at": "2026-11-23T13:20:05Z", "passed": false, "reasons": ["limit broken: ..."],
//    "reference": false, "metrics": {"time_s": 12.5, ..., "dose_target_share": null}}
// Where the trainee gave a name or a number, "name": "..." stands beside them; a result of who gave
// none names nobody. Of a lesson that was begun from a course with pass marks of its own,
// "course_pass": [{"what": "time_s", "at_most": 60}] and "passed_lesson": true, the verdict
// without them.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/lesson/lesson_run.h"

namespace hepatica {

// The quantities that grow over a lesson, those of the moment left out.
inline constexpr std::size_t metric_count = static_cast<std::size_t>(Quantity::step_time_s);

struct Attempt {
    std::filesystem::path recording;
    std::string lesson;                  // its name
    std::string name;                    // of the trainee, as he gave it; empty: nobody is named
    std::string ended_at;                // UTC, as in ISO 8601, so that texts sort as times
    bool passed = false;                 // by all marks it was played under
    std::vector<Predicate> course_pass;  // those of a course among them
    bool passed_lesson = false;          // by the lesson's own alone
    std::vector<std::string> reasons;    // why it was not passed
    bool reference = false;              // others are measured by it, as by an instructor's
    std::array<double, metric_count> metrics{};  // by quantity; NaN: not known

    double value(Quantity quantity) const { return metrics[static_cast<std::size_t>(quantity)]; }
};

// The attempt that ended like this; `course_pass`: the last ones of the standing's pass marks, of
// the course that it was begun from.
Attempt attempt_of(const std::filesystem::path& recording, const std::string& lesson,
                   const LessonStanding& standing, const std::string& ended_at,
                   std::vector<Predicate> course_pass = {});

std::filesystem::path result_file_of(const std::filesystem::path& recording);
// Whole or not at all. Throws InputError where it cannot be written.
void write_attempt(const Attempt& attempt);
// Throws InputError that names the file, the place in it and what is wrong.
Attempt attempt_from(const std::string& text, const std::filesystem::path& recording,
                     const std::string& place);

struct Attempts {
    std::vector<Attempt> list;             // in the order of time
    std::vector<std::string> passed_over;  // files that cannot be read, and why, in words
};
// Those whose results lie in this folder; none where it cannot be read.
Attempts all_attempts(const std::filesystem::path& folder);
// Those among them at one lesson.
Attempts attempts_at(const std::string& lesson, const std::filesystem::path& folder);

// The names among them, each once, in the order of the alphabet.
std::vector<std::string> names_in(const std::vector<Attempt>& attempts);
// Whom the result beside this recording names; empty: nobody, or there is none that can be read.
std::string name_beside(const std::filesystem::path& recording);
// The same of the pass marks of a course under which it was played; none: of none.
std::vector<Predicate> course_pass_beside(const std::filesystem::path& recording);
// Names the trainee of the attempt whose result lies beside this recording; empty: nobody. Throws
// InputError where there is none that can be read and written.
void name_attempt(const std::filesystem::path& recording, const std::string& name);

// The least and the most of a quantity among the attempts that others are measured by; none where
// there are none, or where it is not known of any.
struct Band {
    double least = 0.0;
    double most = 0.0;
    bool operator==(const Band&) const = default;
};
std::optional<Band> band_of(const std::vector<Attempt>& attempts, Quantity quantity);

// "attempt,ended_at,passed,reference,time_s,..." and one row each, with all digits. Where any of
// them is named, "name" comes last.
std::string to_csv(const std::vector<Attempt>& attempts);

}  // namespace hepatica
