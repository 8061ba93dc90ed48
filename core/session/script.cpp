// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/script.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <utility>
#include <variant>

#include "core/base/error.h"
#include "core/base/json_problem.h"
#include "core/base/program_files.h"
#include "core/base/text_file.h"
#include "core/base/unknown_key.h"
#include "core/base/written_json.h"
#include "core/session/command_ranges.h"

namespace hepatica {

using Json = nlohmann::ordered_json;

namespace {

// Appends the path of a script that works.
std::string with_example(const std::string& advice) {
    std::string example = "assets/scripts/drag.json";
    try {
        example = asset("scripts/drag.json").string();
    } catch (const InputError&) {  // not installed with assets; the caller's problem is another one
    }
    return advice + " such as " + example;
}

[[noreturn]] void refuse(const std::string& problem) {
    throw InputError(problem, "", with_example("See a script that works,"));
}

double number(const Json& json, const char* key, double otherwise) {
    const auto found = json.find(key);
    if (found == json.end()) return otherwise;
    if (!found->is_number()) refuse(std::string(key) + " is not a number");
    return found->get<double>();
}

// A time of which the steps can be counted; 0 where it is left out.
double seconds(const Json& json, const char* key) {
    constexpr double most_s = 86400.0;
    const double time_s = number(json, key, 0.0);
    if (!(time_s >= 0.0 && time_s <= most_s))
        refuse(std::string(key) + " must lie from 0 to 86400 s, which is a day");
    return time_s;
}

Vec3 vector_of(const Json& json, const char* key) {
    const auto found = json.find(key);
    if (found == json.end() || !found->is_array() || found->size() != 3 ||
        !std::ranges::all_of(*found, [](const Json& value) { return value.is_number(); }))
        refuse(std::string(key) + " must be three numbers");
    const Vec3 vector((*found)[0].get<double>(), (*found)[1].get<double>(),
                      (*found)[2].get<double>());
    const NumberRange range = range_of(key);
    for (const double value : vector)
        if (!range.holds(value)) refuse(std::string(key) + " " + outside(value, range));
    return vector;
}

using Keys = std::vector<std::string>;

// Refuses all other keys, so that a misspelt one is not silently ignored.
void know(const Json& json, const Keys& keys) {
    for (const auto& [key, value] : json.items())
        if (std::ranges::find(keys, key) == keys.end())
            throw InputError(unknown_key(key, keys), key,
                             "docs/scenes.md lists the keys of a script");
}

// The keys of the command, without those that the action replaces, and the action's own keys.
Keys keys_of(const Command& command, const Keys& said_otherwise, const Keys& own) {
    Keys keys = own;
    for (const std::string& name : field_names(command))
        if (std::ranges::find(said_otherwise, name) == said_otherwise.end()) keys.push_back(name);
    return keys;
}

ScriptPlace place_of(const Json& action, const char* key = "where") {
    const auto where = action.find(key);
    if (where == action.end() || !where->is_object())
        refuse("needs a \"" + std::string(key) + "\" with point_mm or share_of_longest_path");
    know(*where, {"point_mm", "share_of_longest_path"});
    if (where->size() > 1) refuse("needs either point_mm or share_of_longest_path");
    ScriptPlace place;
    if (where->contains("point_mm")) {
        place.point_mm = vector_of(*where, "point_mm");
    } else {
        const double share = number(*where, "share_of_longest_path", -1.0);
        if (!(share >= 0.0 && share <= 1.0)) refuse("share_of_longest_path must lie from 0 to 1");
        place.share_of_longest_path = share;
    }
    return place;
}

// The action's remaining keys are fields of the command; fields that are left out get their
// defaults.
Command command_of(const std::string& name, Json action, const Command& defaults) {
    Json json = to_json(defaults);
    for (const char* key : {"at_s", "do", "where"}) action.erase(key);
    json.update(action);
    json["command"] = name;
    return command_from_json(json);
}

// {"do": "tool", "tool": "sphere", ...}: the remaining keys are those of the command.
Command tool_of(Json action) {
    const auto kind = action.find("tool");
    const auto is = [&](const char* name) { return kind != action.end() && *kind == name; };
    if (!is("sphere") && !is("capsule") && !is("forceps") && !is("hook"))
        refuse(R"(needs a "tool" that is "sphere", "capsule", "forceps" or "hook")");
    action["kind"] = *kind;
    action.erase("tool");
    return command_of("add_tool", action, AddTool{});
}

// Reads what the action does, and returns the keys that it may have.
Keys read_action(const Json& json, ScriptAction& action) {
    if (action.what == "grab") {
        action.place = place_of(json);
        return {"where"};
    }
    if (action.what == "move") {
        action.by_mm = vector_of(json, "by_mm");
        action.over_s = seconds(json, "over_s");
        return {"by_mm", "over_s"};
    }
    if (action.what == "inject") {
        action.place = place_of(json);
        action.command = command_of("inject_drug", json, InjectDrug{});
        return keys_of(*action.command, {"point_mm"}, {"where"});
    }
    if (action.what == "tool") {
        action.place = place_of(json);
        action.command = tool_of(json);
        return keys_of(*action.command, {"point_mm", "kind"}, {"tool", "where"});
    }
    if (action.what == "move_tool") {
        if (json.contains("to_mm") == json.contains("by_mm")) refuse("needs either to_mm or by_mm");
        if (json.contains("to_mm"))
            action.to_mm = vector_of(json, "to_mm");
        else
            action.by_mm = vector_of(json, "by_mm");
        action.over_s = seconds(json, "over_s");
        return {"to_mm", "by_mm", "over_s"};
    }
    if (action.what == "close_forceps" || action.what == "open_forceps") {
        action.over_s = seconds(json, "over_s");
        return {"over_s"};
    }
    if (action.what == "cut_line") {
        action.place = place_of(json, "from");
        action.to_place = place_of(json, "to");
        CutLine line;
        line.strength = number(json, "strength", 0.0);
        if (!(line.strength >= 0.0 && line.strength <= 1.0))
            refuse("strength must lie from 0 to 1");
        action.command = line;
        return {"from", "to", "strength"};
    }
    if (action.what == "blade") {
        action.command = Blade{vector_of(json, "from_mm"), vector_of(json, "to_mm")};
        action.over_s = seconds(json, "over_s");
        return {"from_mm", "to_mm", "over_s"};
    }
    if (action.what == "release") {
        action.command = ReleaseGrab{};
        return {};
    }
    Json command = json;
    command["command"] = action.what;
    action.command = command_from_json(command);
    return field_names(*action.command);
}

ScriptAction action_from(const Json& json) {
    if (!json.is_object()) refuse("is not an object");
    ScriptAction action;
    action.at_s = seconds(json, "at_s");
    const auto what = json.find("do");
    if (what == json.end() || !what->is_string()) refuse(R"(needs a "do")");
    action.what = what->get<std::string>();
    Keys keys = read_action(json, action);
    keys.insert(keys.end(), {"at_s", "do"});
    know(json, keys);
    return action;
}

// The points of the path, without radii.
std::vector<Vec3> longest_path(const VesselTree& tree) {
    std::vector<double> from_root(tree.segments.size());
    int widest = -1;
    for (const int root : roots(tree))
        if (widest < 0 ||
            tree.segments[root].radii_mm.front() > tree.segments[widest].radii_mm.front())
            widest = root;
    if (widest < 0)
        throw InputError("the vessel tree has no segments", "", "Reconstruct the patient first");
    std::vector<int> component(tree.segments.size(), 0);
    int farthest = widest;
    for (std::size_t s = 0; s < tree.segments.size(); ++s) {
        const VesselSegment& segment = tree.segments[s];
        if (segment.closes_loop) continue;  // ends inside the tree
        const bool is_root = static_cast<int>(s) == widest;
        component[s] = is_root || (segment.parent >= 0 && component[segment.parent] != 0);
        if (component[s] == 0) continue;
        from_root[s] = length_mm(segment) + (is_root ? 0.0 : from_root[segment.parent]);
        if (from_root[s] > from_root[farthest]) farthest = static_cast<int>(s);
    }
    std::vector<int> way;
    for (int s = farthest; s >= 0; s = s == widest ? -1 : tree.segments[s].parent) way.push_back(s);
    std::vector<Vec3> points;
    for (auto s = way.rbegin(); s != way.rend(); ++s)
        points.insert(points.end(), tree.segments[*s].points_mm.begin(),
                      tree.segments[*s].points_mm.end());
    return points;
}

// Assigns a script's actions to the steps in which they happen, in order of time.
class Timetable {
  public:
    Timetable(const VesselTree& tree, double dt_s, int steps)
        : tree_(tree), dt_s_(dt_s), commands_(static_cast<std::size_t>(steps)) {}

    void add(const ScriptAction& action);
    std::vector<std::vector<Command>> take() { return std::move(commands_); }

  private:
    long step_at(double time_s) const { return std::lround(time_s / dt_s_); }
    // Number of steps of an action, at least one.
    long length_of(const ScriptAction& action) const {
        return std::max(1L, step_at(action.over_s));
    }
    void put(long step, const Command& command) {
        if (step < static_cast<long>(commands_.size()))
            commands_[static_cast<std::size_t>(step)].push_back(command);
    }
    void move_hand(const ScriptAction& action);
    void lead_tool(const ScriptAction& action);
    void move_jaws(const ScriptAction& action);
    void draw_blade(const ScriptAction& action);

    const VesselTree& tree_;
    double dt_s_;
    std::vector<std::vector<Command>> commands_;
    std::optional<Vec3> hand_mm_;  // none: only the play knows it, as of a grabbed vertex
};

void Timetable::move_hand(const ScriptAction& action) {
    const long moves = length_of(action);
    for (long i = 1; i <= moves; ++i) {
        const double share = static_cast<double>(i) / static_cast<double>(moves);
        const long step = step_at(action.at_s) + i - 1;
        if (hand_mm_)
            put(step, MoveGrab{*hand_mm_ + share * action.by_mm});
        else
            put(step, ShiftGrab{action.by_mm / static_cast<double>(moves)});
    }
    if (hand_mm_) *hand_mm_ += action.by_mm;
}

void Timetable::lead_tool(const ScriptAction& action) {
    const long moves = length_of(action);
    for (long i = 0; i < moves; ++i) {
        const long step = step_at(action.at_s) + i;
        if (action.to_mm)
            put(step, MoveTool{*action.to_mm, 1.0 / static_cast<double>(moves - i)});
        else
            put(step, ShiftTool{action.by_mm / static_cast<double>(moves)});
    }
}

void Timetable::move_jaws(const ScriptAction& action) {
    const long moves = length_of(action);
    for (long i = 0; i < moves; ++i) {
        const double share = 1.0 / static_cast<double>(moves - i);
        if (action.what == "close_forceps")
            put(step_at(action.at_s) + i, CloseForceps{share});
        else
            put(step_at(action.at_s) + i, OpenForceps{share});
    }
}

void Timetable::draw_blade(const ScriptAction& action) {
    const Blade whole = std::get<Blade>(*action.command);
    const long moves = length_of(action);
    const auto at = [&](long i) {
        const double share = static_cast<double>(i) / static_cast<double>(moves);
        return Vec3(whole.from_mm + share * (whole.to_mm - whole.from_mm));
    };
    for (long i = 0; i < moves; ++i) put(step_at(action.at_s) + i, Blade{at(i), at(i + 1)});
}

void Timetable::add(const ScriptAction& action) {
    const long first = step_at(action.at_s);
    if (action.what == "grab") {
        hand_mm_ = position_of(action.place, tree_);
        put(first, GrabPoint{*hand_mm_});
    } else if (action.what == "move") {
        move_hand(action);
    } else if (action.what == "tool") {
        AddTool tool = std::get<AddTool>(*action.command);
        tool.point_mm = position_of(action.place, tree_);
        put(first, tool);
    } else if (action.what == "move_tool") {
        lead_tool(action);
    } else if (action.what == "close_forceps" || action.what == "open_forceps") {
        move_jaws(action);
    } else if (action.what == "cut_line") {
        CutLine line = std::get<CutLine>(*action.command);
        line.from_mm = position_of(action.place, tree_);
        line.to_mm = position_of(action.to_place, tree_);
        put(first, line);
    } else if (action.what == "blade") {
        draw_blade(action);
    } else if (action.what == "inject") {
        InjectDrug injection = std::get<InjectDrug>(*action.command);
        injection.point_mm = position_of(action.place, tree_);
        put(first, injection);
        put(first, FinishInjection{});
    } else {
        if (const auto* grab = std::get_if<GrabPoint>(&*action.command)) hand_mm_ = grab->point_mm;
        if (const auto* led = std::get_if<MoveGrab>(&*action.command)) hand_mm_ = led->target_mm;
        if (std::holds_alternative<GrabVertex>(*action.command)) hand_mm_.reset();
        const auto* shift = std::get_if<ShiftGrab>(&*action.command);
        if (shift != nullptr && hand_mm_) *hand_mm_ += shift->by_mm;
        put(first, *action.command);
    }
}

}  // namespace

Vec3 position_of(const ScriptPlace& place, const VesselTree& tree) {
    return place.point_mm ? *place.point_mm
                          : point_on_longest_path(tree, *place.share_of_longest_path);
}

Vec3 point_on_longest_path(const VesselTree& tree, double share) {
    const std::vector<Vec3> points = longest_path(tree);
    double length = 0.0;
    for (std::size_t i = 1; i < points.size(); ++i) length += (points[i] - points[i - 1]).norm();
    double left = share * length;
    for (std::size_t i = 1; i < points.size(); ++i) {
        const Vec3 edge = points[i] - points[i - 1];
        if (left <= edge.norm() && edge.norm() > 0.0)
            return points[i - 1] + left / edge.norm() * edge;
        left -= edge.norm();
    }
    return points.back();
}

Script read_script(const std::filesystem::path& file) {
    return script_of(read_text_file(file, with_example("Give a script")), file);
}

Script script_of(const std::string& text, const std::filesystem::path& file) {
    Script script;
    std::size_t number = 0;
    try {
        const Json json = parse_written<Json>(text);
        if (!json.is_object() || !json.contains("actions") || !json["actions"].is_array())
            throw InputError("is not a script", "", with_example("Give a script"));
        know(json, {"name", "scene", "actions"});
        script.name = json.value("name", file.stem().string());
        if (json.contains("scene")) script.scene = scene_from_json(json["scene"]);
        for (const Json& action : json["actions"]) {
            ++number;
            script.actions.push_back(action_from(action));
        }
    } catch (const InputError& error) {
        const std::string where = number == 0 ? "" : ", action " + std::to_string(number);
        const std::string what = error.place().empty() ? "" : error.place() + " ";
        throw InputError(what + error.problem(), file.string() + where, error.remedy());
    } catch (const Json::exception& error) {  // no JSON, or a value has the wrong type
        throw InputError(json_problem(error), file.string(), with_example("Give a script"));
    }
    std::ranges::stable_sort(script.actions, {}, &ScriptAction::at_s);
    return script;
}

std::vector<std::vector<Command>> schedule(const Script& script, const VesselTree& tree,
                                           double dt_s, int steps) {
    Timetable table(tree, dt_s, steps);
    for (const ScriptAction& action : script.actions) table.add(action);
    return table.take();
}

}  // namespace hepatica
