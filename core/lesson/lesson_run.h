// SPDX-License-Identifier: GPL-3.0-or-later
// One attempt at a lesson: fed with every step of a play, live or replayed, it says which step is
// reached, which limit is broken, and whether the attempt is passed. It ends with the last step
// reached or the first limit broken; what comes later changes nothing.
#pragma once

#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/lesson/lesson.h"
#include "core/lesson/play_meter.h"
#include "core/session/command.h"

namespace hepatica {

enum class LessonOutcome { running, passed, failed };

// How a bound stands. Of a goal and of a pass mark `value` is the present one, of a limit the worst
// so far; NaN: not yet known, and of a pass mark that the attempt ended before it was asked for.
struct BoundStanding {
    Predicate predicate;
    double value = 0.0;
    bool kept = false;
};

struct StepStanding {
    std::optional<double> reached_s;  // metric time
    double held_s = 0.0;              // of its hold_s, of the present step
};

// A value: what a panel shows and a report prints.
struct LessonStanding {
    LessonOutcome outcome = LessonOutcome::running;
    std::vector<std::string> reasons;  // why it failed
    std::size_t step = 0;              // the present one; the number of steps once all are reached
    std::vector<StepStanding> steps;
    std::vector<BoundStanding> goal;    // of the present step
    std::vector<BoundStanding> limits;  // the lesson's, then each step's as far as it began
    std::vector<BoundStanding> pass;
    LessonMetrics metrics;
    LessonMoment moment;
};

// One point for each step, for plots.
struct LessonSample {
    double time_s = 0.0;
    double force_mn = 0.0;
    double stretch = 1.0;
    double leak_g_s = 0.0;
};

// Not thread-safe.
class LessonRun {
  public:
    // `more_pass`: pass marks beside the lesson's own, of a course. Throws InputError where the
    // lesson names a place that the patient has not.
    LessonRun(Lesson lesson, const std::shared_ptr<const PatientCase>& patient,
              std::vector<Predicate> more_pass = {});

    const Lesson& lesson() const { return lesson_; }
    // What is to be posted before the first step: the lesson's setup on this patient.
    const std::vector<Command>& setup() const { return setup_; }

    // After every step of the play from its first on: the commands applied before it, and its
    // frame. The first step is the setup's. Throws InputError where an injection cannot flow.
    void see(std::span<const Command> commands, const Frame& frame);
    // No more steps come: what is still running has failed.
    void end();

    const LessonStanding& standing() const { return standing_; }
    const std::vector<LessonSample>& samples() const { return samples_; }
    // Where the lesson's marks are in a frame.
    std::vector<Vec3> marks_in(const Frame& frame) const { return meter_.marks_in(frame); }

  private:
    void check_setup(std::span<const Command> commands);
    void check_tools(std::span<const Command> commands);
    void check_limits();
    void check_goal();
    void see_step(std::span<const Command> commands, const Frame& frame);
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

// Why an attempt fails: the limit that it broke, or the pass mark that it missed.
std::string reason_of_limit(const BoundStanding& limit, std::span<const std::string> mark_names);
std::string reason_of_pass_mark(const BoundStanding& mark, std::span<const std::string> mark_names);

// {"lesson", "passed", "reasons", "steps", "limits", "pass_marks", "metrics"}: nothing of wall
// time, so that a live play and its replay give the same text.
nlohmann::ordered_json to_json(const LessonStanding& standing, const Lesson& lesson);

}  // namespace hepatica
