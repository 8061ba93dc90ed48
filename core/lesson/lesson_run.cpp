// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lesson/lesson_run.h"

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>
#include <utility>

#include "core/lesson/allowed_commands.h"
#include "core/lesson/tool_in_hand.h"
#include "core/session/session_inbox.h"

namespace hepatica {

namespace {

// As a session takes them over: of consecutive moves only the newest, so that the recording, by
// which the setup is checked, has no other.
std::vector<Command> setup_of(const Lesson& lesson, const PatientCase& patient) {
    const auto steps = schedule(lesson.setup, patient.tree, lesson.scene.dt_s, 1);
    SessionInbox inbox;
    for (const Command& command : steps.front()) inbox.post(command);
    return inbox.take_commands();
}

// A choice on the dial is recorded as the setting that it led to.
bool is_recorded_as(const Command& given, const Command& recorded) {
    const bool of_dial = std::holds_alternative<SetQuality>(given) ||
                         std::holds_alternative<SetAutomaticQuality>(given);
    if (of_dial) return std::holds_alternative<UseSetting>(recorded);
    return to_json(given) == to_json(recorded);
}

}  // namespace

LessonRun::LessonRun(Lesson lesson, const std::shared_ptr<const PatientCase>& patient,
                     std::vector<Predicate> more_pass)
    : lesson_(std::move(lesson)),
      setup_(setup_of(lesson_, *patient)),
      meter_(lesson_, patient),
      pass_(lesson_.pass) {
    add_new(more_pass, pass_);
    standing_.steps.resize(lesson_.steps.size());
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    for (const Predicate& limit : lesson_.limits)
        standing_.limits.push_back({limit, unknown, true});
    for (const Predicate& mark : pass_) standing_.pass.push_back({mark, unknown, false});
    begin_step();
}

double LessonRun::value_of(const Predicate& predicate) const {
    return hepatica::value_of(predicate, meter_.metrics(), meter_.moment(),
                              meter_.metrics().time_s - step_began_s_);
}

void LessonRun::begin_step() {
    const LessonStep& step = lesson_.steps[standing_.step];
    step_began_s_ = meter_.metrics().time_s;
    first_limit_of_step_ = standing_.limits.size();
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    for (const Predicate& limit : step.limits) standing_.limits.push_back({limit, unknown, true});
    standing_.tool_missing = step.tool.has_value();  // until a frame shows it
    standing_.goal.clear();
    for (const Predicate& goal : step.goal) standing_.goal.push_back({goal, unknown, false});
}

void LessonRun::fail(const std::string& reason) {
    standing_.outcome = LessonOutcome::failed;
    if (std::ranges::find(standing_.reasons, reason) == standing_.reasons.end())
        standing_.reasons.push_back(reason);
}

// The first step must contain the setup. Other commands in it may only be those that need no
// permission (the program's own settings).
void LessonRun::check_setup(std::span<const Command> commands) {
    std::size_t done = 0;
    for (const Command& command : commands) {
        if (done < setup_.size() && is_recorded_as(setup_[done], command))
            ++done;
        else if (!objection_to(command, Lesson{}).empty())
            fail("something was done before the lesson began");
    }
    if (done < setup_.size()) fail("the play does not begin with what the lesson sets up");
}

void LessonRun::check_tools(std::span<const Command> commands) {
    for (const Command& command : commands)
        if (const std::string objection = objection_to(command, lesson_); !objection.empty())
            fail(objection);
}

// A tool or a grab may be replaced within a step, which the frames alone do not show.
void LessonRun::see_taken(std::span<const Command> commands) {
    for (const Command& command : commands) {
        if (std::holds_alternative<AddTool>(command)) meter_.take_another_tool();
        if (std::holds_alternative<GrabPoint>(command) ||
            std::holds_alternative<GrabVertex>(command))
            meter_.take_another_hold();
    }
}

void LessonRun::check_limits() {
    const std::vector<std::string> marks = lesson_.mark_names();
    for (std::size_t i = 0; i < standing_.limits.size(); ++i) {
        const bool of_earlier_step = i >= lesson_.limits.size() && i < first_limit_of_step_;
        if (of_earlier_step) continue;
        BoundStanding& limit = standing_.limits[i];
        const double now = value_of(limit.predicate);
        if (now != now) continue;  // unknown: breaks no limit
        limit.value = limit.value == limit.value ? limit.predicate.worse(limit.value, now) : now;
        limit.kept = limit.predicate.holds(limit.value);
        if (!limit.kept) fail(reason_of_limit(limit, marks));
    }
}

void LessonRun::check_goal(const Frame& frame) {
    const std::optional<LessonTool> tool = lesson_.steps[standing_.step].tool;
    standing_.tool_missing = tool && !is_in_hand(*tool, frame);
    bool all = true;
    for (BoundStanding& goal : standing_.goal) {
        goal.value = value_of(goal.predicate);
        goal.kept = !standing_.tool_missing && goal.predicate.holds(goal.value);
        all = all && goal.kept;
    }
    StepStanding& step = standing_.steps[standing_.step];
    // The first step after which the goal holds counts in full. `rounding` allows for the sum's
    // error.
    constexpr double rounding = 1e-9;
    if (!all) {
        step.held_s = 0.0;
        return;
    }
    const double hold_s = lesson_.steps[standing_.step].hold_s;
    step.held_s += lesson_.scene.dt_s;
    if (step.held_s + rounding < hold_s) return;
    step.held_s = hold_s;
    step.reached_s = meter_.metrics().time_s;
    step.goal = standing_.goal;
    if (++standing_.step < lesson_.steps.size())
        begin_step();
    else
        finish();
}

// Updates the pass marks while the attempt runs. They decide only at the end of the last step.
void LessonRun::see_pass_marks() {
    const bool running = standing_.outcome == LessonOutcome::running;
    const bool reached = standing_.step == lesson_.steps.size();
    if (reached) return;
    for (BoundStanding& mark : standing_.pass) {
        mark.value = running ? value_of(mark.predicate) : std::numeric_limits<double>::quiet_NaN();
        mark.kept = running && mark.predicate.holds(mark.value);
    }
}

void LessonRun::finish() {
    standing_.goal.clear();
    standing_.tool_missing = false;
    const std::vector<std::string> marks = lesson_.mark_names();
    standing_.outcome = LessonOutcome::passed;
    for (BoundStanding& mark : standing_.pass) {
        mark.value = value_of(mark.predicate);
        mark.kept = mark.predicate.holds(mark.value);
        if (!mark.kept) fail(reason_of_pass_mark(mark, marks));
    }
}

void LessonRun::see(std::span<const Command> commands, const Frame& frame,
                    const std::stop_token& stop) {
    if (standing_.outcome != LessonOutcome::running) return;
    see_step(commands, frame, stop);
    see_pass_marks();
}

void LessonRun::see_step(std::span<const Command> commands, const Frame& frame,
                         const std::stop_token& stop) {
    if (!begun_) {
        begun_ = true;
        check_setup(commands);
        meter_.begin(frame);
        standing_.moment = meter_.moment();
        return;
    }
    check_tools(commands);
    see_taken(commands);
    if (frame.statistics.diverged) fail("the simulation stopped by itself: play it again");
    if (!frame.statistics.paused) {
        meter_.see(frame, stop);
        standing_.metrics = meter_.metrics();
        standing_.moment = meter_.moment();
        samples_.push_back({standing_.metrics.time_s, standing_.moment.force_mn,
                            standing_.moment.stretch, standing_.moment.leak_g_s,
                            standing_.moment.target_filled, standing_.moment.elsewhere_filled});
        check_limits();
        if (standing_.outcome == LessonOutcome::running) check_goal(frame);
    }
}

void LessonRun::end() {
    if (standing_.outcome != LessonOutcome::running) return;
    fail("step " + std::to_string(standing_.step + 1) + " of " +
         std::to_string(lesson_.steps.size()) +
         " was not reached: " + lesson_.steps[standing_.step].text);
    see_pass_marks();
}

std::string reason_of_limit(const BoundStanding& limit, std::span<const std::string> mark_names) {
    return "limit broken: " + to_words(limit.predicate, mark_names) + ", but it was " +
           to_words_beside(limit.predicate, limit.value);
}

std::string reason_of_pass_mark(const BoundStanding& mark,
                                std::span<const std::string> mark_names) {
    return "pass mark missed: " + to_words(mark.predicate, mark_names) + ", but it is " +
           to_words(mark.predicate.quantity, mark.value);
}

nlohmann::ordered_json to_json(const LessonStanding& standing, const Lesson& lesson) {
    using Json = nlohmann::ordered_json;
    const std::vector<std::string> marks = lesson.mark_names();
    const auto rows = [&](const std::vector<BoundStanding>& bounds) {
        Json list = Json::array();
        for (const BoundStanding& bound : bounds)
            list.push_back({{"bound", to_words(bound.predicate, marks)},
                            {"value", bound.value},
                            {"kept", bound.kept}});
        return list;
    };
    Json json;
    json["lesson"] = lesson.name;
    json["passed"] = standing.outcome == LessonOutcome::passed;
    json["reasons"] = standing.reasons;
    json["steps"] = Json::array();
    for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
        const auto& reached = standing.steps[i].reached_s;
        json["steps"].push_back({{"text", lesson.steps[i].text},
                                 {"reached_s", reached ? Json(*reached) : Json(nullptr)}});
    }
    json["limits"] = rows(standing.limits);
    json["pass_marks"] = rows(standing.pass);
    json["metrics"] = to_json(standing.metrics);
    return json;
}

}  // namespace hepatica
