// SPDX-License-Identifier: GPL-3.0-or-later
// Derives the events of a play from its commands and frames, step by step, for the time line of a
// review.
#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <vector>

#include "core/lesson/lesson_run.h"
#include "core/scene/frame.h"
#include "core/scene/grip_watch.h"
#include "core/session/command.h"

namespace hepatica {

enum class PlayEventKind {
    hand,
    tool,
    drug,
    cut,
    near_tear,
    tear,
    blood,
    lesson,      // a step reached, or the lesson passed
    not_passed,  // with the reason
    trouble
};
const char* name_of(PlayEventKind kind);

struct PlayEvent {
    double at_s = 0.0;  // since the play began, without pauses
    PlayEventKind kind = PlayEventKind::hand;
    std::string text;  // shown to the user
    bool operator==(const PlayEvent&) const = default;
};

// {"at_s": 1.5, "kind": "tear", "text": "Torn"}
nlohmann::ordered_json to_json(const PlayEvent& event);

// Not thread-safe.
class PlayEvents {
  public:
    // A joint at this share of its limit is about to tear. The next warning comes only after all
    // loads have fallen below `eased_load`.
    static constexpr float near_load = 0.8F;
    static constexpr float eased_load = 0.6F;
    // Returns the events of one step: the commands before it and its frame. Call in order.
    // `standing`: of the lesson after this step; null if none is played.
    std::vector<PlayEvent> see(double at_s, std::span<const Command> commands, const Frame& frame,
                               const LessonStanding* standing);

  private:
    void see_commands(std::span<const Command> commands, const Frame& frame);
    void see_tool(const AddTool& tool);
    void see_grip(const Frame& frame);
    void see_contact(const Frame& frame, double before_s);  // the time of the frame before
    void see_whether_it_tears(const Frame& frame);
    void see_tear(const TearView& now);
    void see_trouble(const Frame& frame);
    void see_lesson(const LessonStanding& standing);
    void note(PlayEventKind kind, std::string text);

    double at_s_ = 0.0;
    std::vector<PlayEvent> found_;  // of the present step
    bool begun_ = false;
    bool held_ = false;        // by the hand
    double touched_s_ = -1e9;  // when a tool touched last
    bool near_ = false;        // to tearing
    bool diverged_ = false;
    bool by_blade_ = false;  // a blade is drawn in this step
    bool torn_ = false;      // "Torn" was noted since the vessels were whole
    bool tears_ = false;     // the frame before had a tear to show
    TearView tear_;          // of the frame before
    std::string message_;
    std::size_t lesson_step_ = 0;
    bool lesson_ended_ = false;
    GripWatch grip_;
    std::string in_hand_;  // the kind of the tool; empty: none
};

}  // namespace hepatica
