// SPDX-License-Identifier: GPL-3.0-or-later
// One attempt at a lesson. Fed with every step of a play, live or replayed, it tells which step is
// reached, which limit is broken, and whether the attempt is passed. It ends when the last step is
// reached or a limit is broken; later steps change nothing.
#pragma once

#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "core/lesson/lesson.h"
#include "core/lesson/play_meter.h"
#include "core/session/command.h"

namespace hepatica {

enum class LessonOutcome { running, passed, failed };

// State of a bound. `value`: of goals and pass marks the present one, of limits the worst so far.
// NaN: unknown, also of pass marks after an attempt that did not reach the end.
struct BoundStanding {
    Predicate predicate;
    double value = 0.0;
    bool kept = false;
};

struct StepStanding {
    std::optional<double> reached_s;  // metric time
    double held_s = 0.0;              // how long its goal has held
    std::vector<BoundStanding> goal;  // as it stood when the step was reached; empty before
};

// State of an attempt, as panels and reports show it.
struct LessonStanding {
    LessonOutcome outcome = LessonOutcome::running;
    std::vector<std::string> reasons;  // why it failed, in words
    std::size_t step = 0;  // index of the present step; steps.size() when all are reached
    std::vector<StepStanding> steps;
    std::vector<BoundStanding> goal;    // of the present step
    std::vector<BoundStanding> limits;  // the lesson's, then those of each step begun so far
    std::vector<BoundStanding> pass;
    LessonMetrics metrics;
    LessonMoment moment;
    bool tool_missing = false;  // the present step names a tool that is not in hand
};

// One sample per step that is not paused, for plots.
struct LessonSample {
    double time_s = 0.0;
    double force_mn = 0.0;
    double stretch = 1.0;
    double leak_g_s = 0.0;
    double target_filled = 0.0;
    double elsewhere_filled = 0.0;
};

// Not thread-safe.
class LessonRun {
  public:
    // `more_pass`: additional pass marks of a course; duplicates are dropped. Throws InputError
    // where the setup or a place does not fit the patient.
    LessonRun(Lesson lesson, const std::shared_ptr<const PatientCase>& patient,
              std::vector<Predicate> more_pass = {});

    const Lesson& lesson() const { return lesson_; }
    // The commands to post before the first step: the lesson's setup on this patient.
    const std::vector<Command>& setup() const { return setup_; }

    // Call after every step from the first: the commands applied before the step, and its frame.
    // The first step is that of the setup. Throws InputError where an injection cannot flow, and
    // Cancelled where its dose is waited for and a stop is requested: the attempt cannot go on
    // then.
    void see(std::span<const Command> commands, const Frame& frame,
             const std::stop_token& stop = {});
    // Call after the last step: an attempt that is still running has failed.
    void end();

    const LessonStanding& standing() const { return standing_; }
    const std::vector<LessonSample>& samples() const { return samples_; }
    // Positions of the lesson's marks in mm, see PlayMeter.
    std::vector<Vec3> marks_in(const Frame& frame) const { return meter_.marks_in(frame); }

  private:
    void check_setup(std::span<const Command> commands);
    void check_tools(std::span<const Command> commands);
    void see_taken(std::span<const Command> commands);
    void check_limits();
    void check_goal(const Frame& frame);
    void see_step(std::span<const Command> commands, const Frame& frame,
                  const std::stop_token& stop);
    void see_pass_marks();
    void begin_step();
    void finish();
    void fail(const std::string& reason);
    double value_of(const Predicate& predicate) const;

    Lesson lesson_;
    std::vector<Command> setup_;
    PlayMeter meter_;
    std::vector<Predicate> pass_;
    bool begun_ = false;
    double step_began_s_ = 0.0;
    std::size_t first_limit_of_step_ = 0;  // in standing_.limits
    LessonStanding standing_;
    std::vector<LessonSample> samples_;
};

// Sentences for a broken limit and a missed pass mark.
std::string reason_of_limit(const BoundStanding& limit, std::span<const std::string> mark_names);
std::string reason_of_pass_mark(const BoundStanding& mark, std::span<const std::string> mark_names);

// {"lesson", "passed", "reasons", "steps", "limits", "pass_marks", "metrics"}. Contains no wall
// time, so that a play and its replay give the same text.
nlohmann::ordered_json to_json(const LessonStanding& standing, const Lesson& lesson);

}  // namespace hepatica
