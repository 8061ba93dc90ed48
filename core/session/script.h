// SPDX-License-Identifier: GPL-3.0-or-later
// A list of timed actions that can be played on any patient, because places can be given by anatomy
// instead of coordinates. `hepatica-cli simulate --script` plays it. Examples: assets/scripts.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/scene/scene_spec.h"
#include "core/session/command.h"
#include "core/tree/vessel_tree.h"

namespace hepatica {

// A place on a tree. Exactly one of the two is set.
struct ScriptPlace {
    std::optional<Vec3> point_mm{};
    // On the path from the root of the widest tree to its farthest end, as a share of its length: 0
    // is the root, 1 the end.
    std::optional<double> share_of_longest_path{};
};

struct ScriptAction {
    double at_s = 0.0;
    // grab, move, release, inject, tool, move_tool, close_forceps, open_forceps, or the name of a
    // plain command
    std::string what;
    ScriptPlace place{};          // of grab, inject and tool; start of a cut line
    ScriptPlace to_place{};       // end of a cut line
    Vec3 by_mm = Vec3::Zero();    // of move and move_tool: displacement from the present target
    std::optional<Vec3> to_mm{};  // of move_tool, instead of by_mm
    double over_s = 0.0;          // of moves, forceps and blade: duration, at constant speed
    std::optional<Command> command{};  // plain command, or the action's, with its settings
};

struct Script {
    std::string name;
    std::optional<SceneSpec> scene;
    std::vector<ScriptAction> actions;  // in order of time
};

// {"name": ..., "scene": {...}, "actions": [
//    {"at_s": 0,   "do": "inject", "where": {"share_of_longest_path": 0}, "mass_flow_g_s": 2},
//    {"at_s": 0.2, "do": "grab", "where": {"point_mm": [1, 2, 3]}},
//    {"at_s": 0.2, "do": "move", "by_mm": [20, 0, 0], "over_s": 1},
//    {"at_s": 2,   "do": "release"},
//    {"at_s": 2.5, "do": "tool", "tool": "capsule", "radius_mm": 2, "length_mm": 20,
//     "direction": [0, 0, -1], "where": {"share_of_longest_path": 0.5}},
//    {"at_s": 2.5, "do": "move_tool", "by_mm": [0, 0, -10], "over_s": 1},   (or "to_mm")
//    {"at_s": 4,   "do": "remove_tool"},
//    {"at_s": 4.5, "do": "tool", "tool": "forceps", "radius_mm": 1.5, "length_mm": 20,
//     "direction": [0, 1, 0], "side": [0, 0, 1], "where": {"share_of_longest_path": 0.5}},
//    {"at_s": 5,   "do": "close_forceps", "over_s": 0.5},               (and "open_forceps")
//    {"at_s": 6,   "do": "cut_line", "from": {"share_of_longest_path": 0.4},
//     "to": {"share_of_longest_path": 0.4}, "strength": 0.1},
//    {"at_s": 7,   "do": "blade", "from_mm": [1, 2, 3], "to_mm": [9, 2, 3], "over_s": 0.5},
//    {"at_s": 3,   "do": "set_gravity", "gravity_mm_per_s2": [0, 9806.65, 0]}]}
// Throws InputError that names the file, the action and what is wrong with it.
Script read_script(const std::filesystem::path& file);
// The same for a text, called `place` in errors; the stem of `place` names a script without a name.
Script script_of(const std::string& text, const std::filesystem::path& place);

// The commands of each of `steps` steps. The step of an injection waits for its computation, so
// that later steps do not depend on the machine's speed. Throws InputError for an empty tree.
std::vector<std::vector<Command>> schedule(const Script& script, const VesselTree& tree,
                                           double dt_s, int steps);

// The point at this share of the path from the root of the widest tree to its farthest end.
Vec3 point_on_longest_path(const VesselTree& tree, double share);
// Where a place is on this tree.
Vec3 position_of(const ScriptPlace& place, const VesselTree& tree);

}  // namespace hepatica
