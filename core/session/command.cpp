// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/command.h"

#include <array>
#include <concepts>
#include <functional>
#include <nlohmann/json.hpp>
#include <utility>

#include "core/base/error.h"
#include "core/base/json_number.h"
#include "core/scene/setting_json.h"
#include "core/session/command_ranges.h"

namespace hepatica {

using Json = nlohmann::ordered_json;

namespace {

// One description of each command's fields serves writing and reading.
template <class Visitor>
void fields(GrabPoint& c, Visitor& v) {
    v("point_mm", c.point_mm);
}
template <class Visitor>
void fields(GrabVertex& c, Visitor& v) {
    v("vertex", c.vertex);
}
template <class Visitor>
void fields(MoveGrab& c, Visitor& v) {
    v("target_mm", c.target_mm);
    v("over_s", c.over_s);
}
template <class Visitor>
void fields(ShiftGrab& c, Visitor& v) {
    v("by_mm", c.by_mm);
}
template <class Visitor>
void fields(ReleaseGrab&, Visitor&) {}
template <class Visitor>
void fields(AddTool& c, Visitor& v) {
    v("kind", c.kind);
    v("radius_mm", c.radius_mm);
    v("length_mm", c.length_mm);
    v("direction", c.direction);
    v("point_mm", c.point_mm);
    v("side", c.side);
}
template <class Visitor>
void fields(MoveTool& c, Visitor& v) {
    v("target_mm", c.target_mm);
    v("share", c.share);
    v("over_s", c.over_s);
}
template <class Visitor>
void fields(ShiftTool& c, Visitor& v) {
    v("by_mm", c.by_mm);
}
template <class Visitor>
void fields(RemoveTool&, Visitor&) {}
template <class Visitor>
void fields(TurnTool& c, Visitor& v) {
    v("by_rad", c.by_rad);
}
template <class Visitor>
void fields(CloseForceps& c, Visitor& v) {
    v("share", c.share);
}
template <class Visitor>
void fields(OpenForceps& c, Visitor& v) {
    v("share", c.share);
}
template <class Visitor>
void fields(UseTools& c, Visitor& v) {
    v("on", c.on);
}
template <class Visitor>
void fields(UseContact& c, Visitor& v) {
    v("self", c.self);
    v("obstacles", c.obstacles);
    v("friction", c.friction);
}
template <class Visitor>
void fields(CutLine& c, Visitor& v) {
    v("from_mm", c.from_mm);
    v("to_mm", c.to_mm);
    v("strength", c.strength);
}
template <class Visitor>
void fields(Blade& c, Visitor& v) {
    v("from_mm", c.from_mm);
    v("to_mm", c.to_mm);
}
template <class Visitor>
void fields(UseTear& c, Visitor& v) {
    v("on", c.on);
    v("tear_factor", c.tear_factor);
}
template <class Visitor>
void fields(InjectDrug& c, Visitor& v) {
    v("point_mm", c.point_mm);
    v("mass_flow_g_s", c.mass_flow_g_s);
    v("void_fraction", c.void_fraction);
    v("second_phase", c.second_phase);
    v("pressure_model", c.pressure_model);
    v("drug_viscosity_pa_s", c.drug_viscosity_pa_s);
}
template <class Visitor>
void fields(FinishInjection&, Visitor&) {}
template <class Visitor>
void fields(RemoveDrug&, Visitor&) {}
template <class Visitor>
void fields(PlayDrug& c, Visitor& v) {
    v("playing", c.playing);
}
template <class Visitor>
void fields(SetDrugTime& c, Visitor& v) {
    v("time_s", c.time_s);
}
template <class Visitor>
void fields(SetDrugSpeed& c, Visitor& v) {
    v("factor", c.factor);
}
template <class Visitor>
void fields(SetGravity& c, Visitor& v) {
    v("gravity_mm_per_s2", c.gravity_mm_per_s2);
}
template <class Visitor>
void fields(SetTether& c, Visitor& v) {
    v("pa_per_mm2", c.pa_per_mm2);
}
template <class Visitor>
void fields(SetQuality& c, Visitor& v) {
    v("quality", c.quality);
}
template <class Visitor>
void fields(SetPaused& c, Visitor& v) {
    v("paused", c.paused);
}
template <class Visitor>
void fields(SetAutomaticQuality& c, Visitor& v) {
    v("automatic", c.automatic);
}
template <class Visitor>
void fields(UseSetting& c, Visitor& v) {
    v("setting", c.setting);
}
template <class Visitor>
void fields(SetWall& c, Visitor& v) {
    v("wall_mm", c.wall_mm);
}
template <class Visitor>
void fields(ResetWorld&, Visitor&) {}
template <class Visitor>
void fields(RestoreSnapshot&, Visitor&) {}

// Names in the order of the variant's alternatives.
constexpr std::array<const char*, std::variant_size_v<Command>> names{
    "grab_point",     "grab_vertex",   "move_grab",        "release_grab",
    "inject_drug",    "remove_drug",   "play_drug",        "set_drug_time",
    "set_drug_speed", "set_gravity",   "set_tether",       "set_quality",
    "set_paused",     "reset_world",   "restore_snapshot", "set_automatic_quality",
    "use_setting",    "set_wall",      "finish_injection", "add_tool",
    "move_tool",      "shift_tool",    "remove_tool",      "turn_tool",
    "use_tools",      "close_forceps", "open_forceps",     "cut_line",
    "blade",          "use_tear",      "use_contact",      "shift_grab"};

struct Writer {
    Json& json;

    template <class T>
    void operator()(const char* name, const T& value) {
        json[name] = value;
    }
    void operator()(const char* name, const Vec3& value) {
        json[name] = {value.x(), value.y(), value.z()};
    }
    void operator()(const char* name, const StepperOptions& value) { json[name] = to_json(value); }
    template <class T>
    void operator()(const char* name, const std::optional<T>& value) {
        if (value) (*this)(name, *value);
    }
};

struct Reader {
    const Json& json;
    const char* command;

    template <class T>
    void operator()(const char* name, T& value) {
        const auto found = json.find(name);
        if (found == json.end()) refuse(name, "is missing");
        try {
            if constexpr (std::integral<T> && !std::same_as<T, bool>)
                value = whole_number<T>(*found);
            else
                value = found->get<T>();
        } catch (const Json::exception&) {
            refuse(name, "has a value of the wrong kind (" + found->dump() + ")");
        }
        if constexpr (std::floating_point<T>) require_in_range(name, value);
    }
    void operator()(const char* name, Vec3& value) {
        std::array<double, 3> numbers{};
        (*this)(name, numbers);
        for (const double number : numbers) require_in_range(name, number);
        value = Vec3(numbers[0], numbers[1], numbers[2]);
    }
    void operator()(const char* name, StepperOptions& value) {
        Json setting;
        (*this)(name, setting);
        value = setting_from_json(setting);
    }
    template <class T>
    void operator()(const char* name, std::optional<T>& value) {
        if (json.contains(name)) (*this)(name, value.emplace());
    }
    void require_in_range(const char* name, double value) const {
        const NumberRange range = range_of(name);
        if (!range.holds(value)) refuse(name, outside(value, range));
    }
    [[noreturn]] void refuse(const char* name, const std::string& problem) const {
        throw InputError(problem, std::string("command ") + command + ", field " + name,
                         "Correct the script or recording");
    }
};

struct NameCollector {
    std::vector<std::string>& names;

    template <class T>
    void operator()(const char* name, const T&) {
        names.emplace_back(name);
    }
};

template <std::size_t I>
Command read_alternative(const Json& json) {
    std::variant_alternative_t<I, Command> command;
    Reader reader{json, names[I]};
    fields(command, reader);
    return command;
}

template <std::size_t... I>
Command read_named(const std::string& name, const Json& json, std::index_sequence<I...>) {
    std::optional<Command> command;
    static_cast<void>(
        ((name == names[I] ? (command = read_alternative<I>(json), true) : false) || ...));
    if (!command)
        throw InputError("\"" + name + "\" is no command", "command",
                         "Correct the script or recording");
    return *command;
}

}  // namespace

Json to_json(const Command& command) {
    Json json{{"command", names[command.index()]}};
    Writer writer{json};
    Command copy = command;
    std::visit([&](auto& alternative) { fields(alternative, writer); }, copy);
    return json;
}

std::vector<std::string> field_names(const Command& command) {
    std::vector<std::string> found;
    NameCollector collector{found};
    Command copy = command;
    std::visit([&](auto& alternative) { fields(alternative, collector); }, copy);
    return found;
}

Command command_from_json(const Json& json) {
    const auto name = json.is_object() ? json.find("command") : json.end();
    if (name == json.end() || !name->is_string())
        throw InputError("has no name", "command", R"(Write {"command": "grab_point", ...})");
    return read_named(name->get<std::string>(), json,
                      std::make_index_sequence<std::variant_size_v<Command>>());
}

}  // namespace hepatica
