// SPDX-License-Identifier: GPL-3.0-or-later
// Plays commands on a session step by step, as fast as possible, and measures what `simulate`
// reports: times, solver, contacts, tears, blood loss, and errors of conserved quantities.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/command_line.h"
#include "app/refusals.h"
#include "app/step_table.h"
#include "app/step_times.h"
#include "core/scene/world.h"
#include "core/session/session.h"

namespace hepatica {

struct MeasuredPlay {
    StepTimes times;
    std::optional<StepTable> table;  // if requested
    Json real_time_factor;           // null where nothing was played
    int linear_iterations_max = 0;
    int degraded_steps = 0;
    std::string degraded_because;  // of the first such step
    int setting_changes = 0;
    Json velocity_error_fit;  // null unless requested
    int contacts_max =
        0;  // contact points in the pad of a tool, and pairs of surface features within their pads
    int obstacle_contacts_max = 0;  // contacts with obstacles
    int rows_max =
        0;  // constraint rows: one normal row per contact, and two more where there is friction
    double penetration_max_mm = 0.0;
    double tool_force_max_un = 0.0;
    int hand_at_limit_steps = 0, tool_at_limit_steps = 0;
    // See MomentumBalance; none where no step exchanged momentum that it measures.
    std::optional<double> momentum_error_relative;
    TearReport tear;       // of the last step
    double torn_nj = 0.0;  // fracture energy
    bool finite = true;
    Refusals refusals;
    std::optional<std::uint64_t> paused_at;  // the step at which a pause ended the play
};

// Optional measurements.
struct PlayWishes {
    bool fit = false;    // fit the velocity error of eq. (11) to the first 120 steps
    bool table = false;  // record a line for each step
};

// Posts commands[i] before step i, and warns of those that are refused. Steps of a pause are not
// measured. Ends early where the session pauses itself after an error, and where the commands pause
// it and none that follows resumes it. Throws Cancelled.
MeasuredPlay measure_play(Session& session, const std::vector<std::vector<Command>>& commands,
                          const PlayWishes& wishes, Job& job);

// Number of obstacle surfaces that the scene's vessels may touch; null where the scene asks for
// none.
Json obstacles_of(const World& world);
// Warns where a scene asks for obstacles and the case has none.
void say_where_obstacles_are_none(const World& world);

// The measurements, and the state of the session at the end; values of parts that the scene lacks
// are null.
Json answer_of(Session& session, const MeasuredPlay& played);

}  // namespace hepatica
