// SPDX-License-Identifier: GPL-3.0-or-later
// Plays commands on a session step by step, as fast as it goes, and measures what `simulate`
// reports: times, solver, touch, tears, blood lost, and the errors of what must be conserved.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/command_line.h"
#include "app/step_table.h"
#include "app/step_times.h"
#include "core/scene/world.h"
#include "core/session/session.h"

namespace hepatica {

struct MeasuredPlay {
    StepTimes times;
    std::optional<StepTable> table;  // where it was asked for
    Json real_time_factor;           // null where nothing was played
    int linear_iterations_max = 0;
    int degraded_steps = 0;
    std::string degraded_because;  // of the first such step
    int setting_changes = 0;
    Json velocity_error_fit;  // null unless asked for
    int contacts_max = 0;     // points in a tool's pad and pairs of features of surfaces in theirs
    int obstacle_contacts_max = 0;  // those with obstacles
    int rows_max = 0;               // normal and, against what has friction, two of that
    double penetration_max_mm = 0.0;
    double tool_force_max_un = 0.0;
    int hand_at_limit_steps = 0, tool_at_limit_steps = 0;
    double momentum_error_relative = 0.0;  // see MomentumBalance
    TearReport tear;                       // of the last step
    double torn_nj = 0.0;                  // energy of fracture
    bool finite = true;
};

// What is measured only where somebody asks for it.
struct PlayWishes {
    bool fit = false;    // of the velocity error of eq. (11) to the first 120 steps
    bool table = false;  // a line for each step
};

// Posts commands[i] before step i; ends early where the session pauses itself. Throws Cancelled.
MeasuredPlay measure_play(Session& session, const std::vector<std::vector<Command>>& commands,
                          const PlayWishes& wishes, Job& job);

// How many surfaces the scene's vessels may touch beside their own; null where it asks for none.
Json obstacles_of(const World& world);
// Warns where a scene takes what obstacles there are, and there are none.
void say_where_obstacles_are_none(const World& world);

// What was measured, and the state of the session at the end; null where the scene has no such
// part.
Json answer_of(Session& session, const MeasuredPlay& played);

}  // namespace hepatica
