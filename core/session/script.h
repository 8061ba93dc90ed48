// SPDX-License-Identifier: GPL-3.0-or-later
// A session written down for any patient: actions at times, places named by the anatomy instead of
// coordinates. `hepatica-cli simulate --script` plays it; docs stand beside assets/scripts.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/scene/scene_spec.h"
#include "core/session/command.h"
#include "core/tree/vessel_tree.h"

namespace hepatica {

// Where on a tree. Exactly one of them is set.
struct ScriptPlace {
    std::optional<Vec3> point_mm{};
    // On the way from the root of the widest component to its farthest end: 0 is the root, 1 the
    // end.
    std::optional<double> share_of_longest_path{};
};

struct ScriptAction {
    double at_s = 0.0;
    std::string what;           // grab, move, release, inject, or the name of a plain command
    ScriptPlace place{};        // of grab and inject
    Vec3 by_mm = Vec3::Zero();  // of move: from where the hand is
    double over_s = 0.0;        // of move: evenly spread over this time
    std::optional<Command> command{};  // of a plain command; of inject: its settings
};

struct Script {
    std::string name;
    std::optional<SceneSpec> scene;
    std::vector<ScriptAction> actions;  // by time
};

// {"name": ..., "scene": {...}, "actions": [
//    {"at_s": 0,   "do": "inject", "where": {"share_of_longest_path": 0}, "mass_flow_g_s": 2},
//    {"at_s": 0.2, "do": "grab", "where": {"point_mm": [1, 2, 3]}},
//    {"at_s": 0.2, "do": "move", "by_mm": [20, 0, 0], "over_s": 1},
//    {"at_s": 2,   "do": "release"},
//    {"at_s": 3,   "do": "set_gravity", "gravity_mm_per_s2": [0, 9806.65, 0]}]}
// Throws InputError that names the file, the action and what is wrong with it.
Script read_script(const std::filesystem::path& file);

// The commands of each step, for as many steps as asked. An injection is waited for at its own
// step, so that what follows does not depend on the machine. Throws InputError for an empty tree.
std::vector<std::vector<Command>> schedule(const Script& script, const VesselTree& tree,
                                           double dt_s, int steps);

// The point at a share of the way from the root of the widest component to its farthest end.
Vec3 point_on_longest_path(const VesselTree& tree, double share);

}  // namespace hepatica
