// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lesson/play_events.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "core/lesson/play_meter.h"

namespace hepatica {

namespace {

struct Words {
    PlayEventKind kind;
    std::string text;
};

// The text of commands that appear on the time line. Motions of the hand and of tools do not: they
// come with every step.
struct WordsOfCommand {
    std::optional<Words> operator()(const RemoveTool&) const {
        return Words{PlayEventKind::tool, "Tool put away"};
    }
    std::optional<Words> operator()(const InjectDrug&) const {
        return Words{PlayEventKind::drug, "Injected"};
    }
    std::optional<Words> operator()(const RemoveDrug&) const {
        return Words{PlayEventKind::drug, "Drug taken out"};
    }
    std::optional<Words> operator()(const CutLine&) const {
        return Words{PlayEventKind::cut, "Cut line drawn"};
    }
    std::optional<Words> operator()(const Blade&) const {
        return Words{PlayEventKind::cut, "Blade drawn"};
    }
    std::optional<Words> operator()(const ResetWorld&) const {
        return Words{PlayEventKind::trouble, "Begun again from rest"};
    }
    std::optional<Words> operator()(const RestoreSnapshot&) const {
        return Words{PlayEventKind::trouble, "Back to the last good state"};
    }
    template <class Other>
    std::optional<Words> operator()(const Other&) const {
        return std::nullopt;
    }
};

// A grab lets go of what was held before.
bool opens_hand(const Command& command) {
    return std::holds_alternative<ReleaseGrab>(command) ||
           std::holds_alternative<GrabPoint>(command) ||
           std::holds_alternative<GrabVertex>(command);
}

float largest(const TearView& tear) {
    if (!tear.loads || tear.loads->empty()) return 0.0F;
    return *std::ranges::max_element(*tear.loads);
}

}  // namespace

const char* name_of(PlayEventKind kind) {
    switch (kind) {
        case PlayEventKind::hand:
            return "hand";
        case PlayEventKind::tool:
            return "tool";
        case PlayEventKind::drug:
            return "drug";
        case PlayEventKind::cut:
            return "cut";
        case PlayEventKind::near_tear:
            return "near_tear";
        case PlayEventKind::tear:
            return "tear";
        case PlayEventKind::blood:
            return "blood";
        case PlayEventKind::lesson:
            return "lesson";
        case PlayEventKind::not_passed:
            return "not_passed";
        case PlayEventKind::trouble:
            break;
    }
    return "trouble";
}

nlohmann::ordered_json to_json(const PlayEvent& event) {
    return {{"at_s", event.at_s}, {"kind", name_of(event.kind)}, {"text", event.text}};
}

void PlayEvents::note(PlayEventKind kind, std::string text) {
    found_.push_back({at_s_, kind, std::move(text)});
}

std::vector<PlayEvent> PlayEvents::see(double at_s, std::span<const Command> commands,
                                       const Frame& frame, const LessonStanding* standing) {
    const double before_s = std::exchange(at_s_, at_s);
    found_.clear();
    by_blade_ = false;
    if (!begun_ && frame.tear) tear_ = *frame.tear;  // tears before the first step are no events
    see_commands(commands, frame);
    see_grip(frame);
    see_contact(frame, before_s);
    see_whether_it_tears(frame);
    see_trouble(frame);
    if (standing != nullptr) see_lesson(*standing);
    begun_ = true;
    return std::exchange(found_, {});
}

void PlayEvents::see_commands(std::span<const Command> commands, const Frame& frame) {
    for (const Command& command : commands) {
        if (opens_hand(command) && std::exchange(held_, false)) note(PlayEventKind::hand, "Let go");
        const auto words = std::visit(WordsOfCommand{}, command);
        if (words) note(words->kind, words->text);
        if (const auto* tool = std::get_if<AddTool>(&command)) see_tool(*tool);
        if (std::holds_alternative<RemoveTool>(command)) in_hand_.clear();
        by_blade_ |= std::holds_alternative<Blade>(command);
    }
    // A click beside the vessel grabs nothing.
    if (frame.grab && !held_) note(PlayEventKind::hand, "Took hold");
    held_ = frame.grab.has_value();
    if (!frame.tool) in_hand_.clear();
}

// The tool in hand may be brought again, to another place or in another size: that is no taking.
void PlayEvents::see_tool(const AddTool& tool) {
    grip_ = {};  // it comes with open jaws
    if (std::exchange(in_hand_, tool.kind) == tool.kind) return;
    const std::string name = tool.kind == "sphere"    ? "Probe"
                             : tool.kind == "capsule" ? "Rod probe"
                             : tool.kind == "hook"    ? "Hook"
                                                      : "Forceps";
    note(PlayEventKind::tool, name + " taken");
}

void PlayEvents::see_grip(const Frame& frame) {
    if (!frame.tool || !frame.tool->has_jaws()) return;
    switch (grip_.see(*frame.tool, frame.tool->closing)) {
        case GripWatch::Seen::closed_on_something:
            return note(PlayEventKind::tool, "Forceps closed: they hold something");
        case GripWatch::Seen::closed_on_nothing:
            return note(PlayEventKind::tool, "Forceps closed: they hold nothing");
        case GripWatch::Seen::slipped:
            return note(PlayEventKind::tool, "Slipped out of the forceps");
        case GripWatch::Seen::opened:
            return note(PlayEventKind::tool, "Forceps opened");
        case GripWatch::Seen::nothing_new:
            break;
    }
}

void PlayEvents::see_contact(const Frame& frame, double before_s) {
    if (!frame.tool || frame.tool->touched.empty()) return;
    if (PlayMeter::begins_contact(before_s - touched_s_)) note(PlayEventKind::tool, "Touched");
    touched_s_ = at_s_;
}

// Tearing may begin and end in mid-play. The whole body may be of several pieces; where it no
// longer tears, it is whole.
void PlayEvents::see_whether_it_tears(const Frame& frame) {
    const bool tore = std::exchange(tears_, frame.tear.has_value());
    if (!tore && !tears_) return;
    if (!tore && frame.tear->joints_broken == 0) tear_.pieces = frame.tear->pieces;
    see_tear(frame.tear.value_or(TearView{}));
}

void PlayEvents::see_tear(const TearView& now) {
    const float load = largest(now);
    if (load >= near_load && !near_) note(PlayEventKind::near_tear, "About to tear");
    if (load >= near_load) near_ = true;
    if (load < eased_load) near_ = false;
    if (now.joints_broken < tear_.joints_broken) {
        note(PlayEventKind::tear, "Whole again");
        torn_ = false;
    }
    // A blade parts joints in the step that it is drawn in; what parts otherwise is torn.
    if (now.joints_broken > tear_.joints_broken) {
        if (by_blade_)
            note(PlayEventKind::cut, "Cut");
        else if (!std::exchange(torn_, true))
            note(PlayEventKind::tear, "Torn");
    }
    if (now.pieces > tear_.pieces) note(PlayEventKind::tear, "A piece came off");
    if (now.leak_g_s > 0.0 && tear_.leak_g_s == 0.0) note(PlayEventKind::blood, "Bleeding began");
    if (now.leak_g_s == 0.0 && tear_.leak_g_s > 0.0) note(PlayEventKind::blood, "Bleeding ended");
    if (!now.stopped_by.empty() && tear_.stopped_by.empty())
        note(PlayEventKind::tear, "Tearing stopped by its budget of " + now.stopped_by);
    tear_ = now;
}

void PlayEvents::see_trouble(const Frame& frame) {
    const FrameStatistics& said = frame.statistics;
    // What the solver says of degraded steps is frequent, and no act of the trainee.
    if (said.message != message_ && !said.message.empty() && !said.message_of_solver)
        note(PlayEventKind::trouble, said.message);
    else if (said.diverged && !diverged_)
        note(PlayEventKind::trouble, "The simulation stopped by itself");
    message_ = said.message;
    diverged_ = said.diverged;
}

void PlayEvents::see_lesson(const LessonStanding& standing) {
    for (; lesson_step_ < standing.step; ++lesson_step_)
        note(PlayEventKind::lesson, "Step " + std::to_string(lesson_step_ + 1) + " reached");
    if (lesson_ended_ || standing.outcome == LessonOutcome::running) return;
    lesson_ended_ = true;
    if (standing.outcome == LessonOutcome::passed) return note(PlayEventKind::lesson, "Passed");
    for (const std::string& reason : standing.reasons)
        note(PlayEventKind::not_passed, "Not passed: " + reason);
}

}  // namespace hepatica
