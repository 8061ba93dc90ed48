// SPDX-License-Identifier: GPL-3.0-or-later
// Results of attempts at lessons, each in a file beside its recording (NAME.result.json beside
// NAME.hrec), for learning curves and comparison with an instructor.
//   {"format": "hepatica-result", "version": 1, "lesson": "Gentle pull",
//    "ended_at": "2026-11-23T13:20:05Z", "passed": false, "reasons": ["limit broken: ..."],
//    "reference": false, "metrics": {"time_s": 12.5, ..., "dose_target_share": null}}
// "name" is added if the trainee gave a name or a number. Attempts begun from a course with its own
// pass marks also have "course_pass": [{"what": "time_s", "at_most": 60}] and "passed_lesson", the
// verdict without them. "lesson_id" is added if the lesson has an id.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/lesson/lesson_run.h"

namespace hepatica {

// The metrics of a whole attempt: quantities before step_time_s; those of a moment come after it.
inline constexpr std::size_t metric_count = static_cast<std::size_t>(Quantity::step_time_s);

struct Attempt {
    std::filesystem::path recording;
    std::string lesson;                          // name of the lesson
    std::string name;                            // of the trainee; empty: not given
    std::string ended_at;                        // UTC in ISO 8601, so that texts sort as times
    bool passed = false;                         // by the lesson's and the course's marks
    std::vector<Predicate> course_pass;          // the marks that only the course asks for
    bool passed_lesson = false;                  // by the lesson's own marks alone
    std::vector<std::string> reasons;            // why it failed
    bool reference = false;                      // a reference for others, such as an instructor's
    std::array<double, metric_count> metrics{};  // by Quantity; NaN: unknown
    std::string lesson_id{};                     // id of the lesson; empty: its name says which

    double value(Quantity quantity) const { return metrics[static_cast<std::size_t>(quantity)]; }
};

// The attempt with this final standing. `course_pass`: the pass marks that the course that it was
// begun from adds to the lesson's own (see add_new()); they must be the last ones of the standing.
Attempt attempt_of(const std::filesystem::path& recording, const std::string& lesson,
                   const LessonStanding& standing, const std::string& ended_at,
                   std::vector<Predicate> course_pass = {});

// The one reason of an attempt that a crash or a power cut ended. It is kept, but counts neither as
// passed nor as failed.
inline constexpr const char* interrupted_reason = "interrupted before the end";
bool was_interrupted(const Attempt& attempt);

std::filesystem::path result_file_of(const std::filesystem::path& recording);
// What a result file holds; see attempt_from().
std::string text_of(const Attempt& attempt);
// Writes result_file_of(attempt.recording) atomically. Throws InputError where that fails.
void write_attempt(const Attempt& attempt);
// Parses the text of a result file. Throws InputError with the file (`place`), the place in it and
// the problem.
Attempt attempt_from(const std::string& text, const std::filesystem::path& recording,
                     const std::string& place);

// The id of a lesson without one that is given another name: attempts without an id that were at a
// lesson of this name are at it.
std::string id_of_former_name(const std::string& name);

struct Attempts {
    std::vector<Attempt> list;             // sorted by time
    std::vector<std::string> passed_over;  // unreadable files, with the reason in words
};
// All attempts with results in this folder; empty if it cannot be read.
Attempts all_attempts(const std::filesystem::path& folder);
// What tells a lesson from others. The name counts for attempts that know no id, as those of older
// programs, and so does an id that was made of the name that the lesson had then.
struct LessonKey {
    std::string id;  // may be empty
    std::string name;
};
bool is_at(const Attempt& attempt, const LessonKey& lesson);
// Those at this lesson.
Attempts attempts_at(const LessonKey& lesson, const std::filesystem::path& folder);

// The distinct non-empty names, sorted bytewise.
std::vector<std::string> names_in(const std::vector<Attempt>& attempts);
// The trainee's name in the result beside this recording; empty if it has none or cannot be read.
std::string name_beside(const std::filesystem::path& recording);
// When that result says that the play ended, as Attempt::ended_at; empty likewise.
std::string ended_at_beside(const std::filesystem::path& recording);
// Whether that result is of an interrupted attempt; false if there is none or it cannot be read.
bool interrupted_beside(const std::filesystem::path& recording);
// The course's pass marks in that result; empty if it has none or cannot be read.
std::vector<Predicate> course_pass_beside(const std::filesystem::path& recording);
// The lesson as that attempt at it was judged: with the course's pass marks.
std::optional<Lesson> with_course_pass(std::optional<Lesson> lesson,
                                       const std::filesystem::path& recording);
// Sets the trainee's name (empty: none) in the result beside this recording. Throws InputError
// where it cannot be read or written.
void name_attempt(const std::filesystem::path& recording, const std::string& name);

// Makes the result beside this recording a reference for others, or no more. Throws InputError as
// above.
void mark_reference(const std::filesystem::path& recording, bool reference);

// Range of a quantity over the reference attempts; nullopt where it is known of none.
struct Band {
    double least = 0.0;
    double most = 0.0;
    bool operator==(const Band&) const = default;
};
std::optional<Band> band_of(const std::vector<Attempt>& attempts, Quantity quantity);

// CSV: the header "lesson,attempt,ended_at,passed,reference,time_s,..." and one row per attempt,
// with six significant digits. A last column "name" is added if any attempt has one.
std::string to_csv(const std::vector<Attempt>& attempts);

}  // namespace hepatica
