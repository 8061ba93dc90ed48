// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/hand_motion.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/base/error.h"
#include "core/base/frame_time.h"

namespace hepatica {
namespace {

constexpr double watched_s = 1.0;  // watched after the last action if the vessel is released

int steps_in(double seconds) {
    return static_cast<int>(std::lround(seconds / frame_s));
}

// Takes the vessel at half of the longest path.
Script held_vessel() {
    Script script;
    script.actions.push_back(
        {.at_s = 0.0, .what = "grab", .place = {.share_of_longest_path = 0.5}});
    return script;
}

// Appends a move; returns when it ends.
double move(Script& script, double at_s, const Vec3& by_mm, double over_s) {
    script.actions.push_back({.at_s = at_s, .what = "move", .by_mm = by_mm, .over_s = over_s});
    return at_s + over_s;
}

void let_go(Script& script, double at_s) {
    script.actions.push_back({.at_s = at_s, .what = "release", .command = ReleaseGrab{}});
}

Script pull() {
    Script script = held_vessel();
    const double turned_s = move(script, 0.0, Vec3(30, 20, 0), 0.5);
    let_go(script, move(script, turned_s, Vec3(-30, -40, 10), 0.5));
    return script;
}

Script jerk() {
    Script script = held_vessel();
    const double turned_s = move(script, 0.0, Vec3(40, 0, 0), 0.1);
    let_go(script, move(script, turned_s, Vec3(-40, 0, 0), 0.1));
    return script;
}

Script twist() {
    constexpr double radius_mm = 15.0, turn_s = 3.0;
    constexpr double two_pi = 2.0 * std::numbers::pi;
    Script script = held_vessel();
    const int steps = steps_in(turn_s);
    Vec3 reached = Vec3::Zero();
    for (int i = 1; i <= steps; ++i) {
        const double angle = two_pi * i / steps;
        const Vec3 place = radius_mm * Vec3(std::cos(angle) - 1.0, std::sin(angle), 0.0);
        move(script, (i - 1) * frame_s, place - reached, frame_s);
        reached = place;
    }
    let_go(script, turn_s);
    return script;
}

double end_s(const Script& script) {
    double end_s = 0.0;
    for (const ScriptAction& action : script.actions)
        end_s = std::max(end_s, action.at_s + action.over_s);
    return end_s;
}

HandMotion watched(std::string name, Script script, double afterwards_s) {
    const double over_s = end_s(script);
    return {std::move(name), std::move(script), steps_in(over_s + afterwards_s), steps_in(over_s)};
}

}  // namespace

std::vector<std::string> hand_motion_names() {
    return {"pull", "jerk", "twist"};
}

HandMotion hand_motion(const std::string& name) {
    Script script;
    if (name == "pull")
        script = pull();
    else if (name == "jerk")
        script = jerk();
    else if (name == "twist")
        script = twist();
    else
        throw InputError("\"" + name + "\" is not known", "motion",
                         "Choose one of: pull, jerk, twist");
    script.name = name;
    return watched(name, std::move(script), watched_s);
}

HandMotion motion_of(const Script& script) {
    return watched("script", script, watched_s);
}

HandMotion dial_motion() {
    const Vec3 way_mm(18, 24, 0);
    Script script = held_vessel();
    const double turned_s = move(script, 0.0, way_mm, 0.5);
    move(script, turned_s, -way_mm, 0.5);
    return watched("dial", std::move(script), 0.0);
}

}  // namespace hepatica
