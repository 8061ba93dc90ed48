// SPDX-License-Identifier: GPL-3.0-or-later
// Everything that a person or a script can do to the world. Commands are plain values. They wait in
// a queue, are applied between two steps only, and are written into the recording unchanged.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/base/vector.h"
#include "core/deform/stepper/stepper_options.h"
#include "core/scene/default_injection.h"

namespace hepatica {

// Grabs the body at the point of its deformed surface nearest to point_mm (for example where the
// mouse's ray met it). An earlier grab is released.
struct GrabPoint {
    Vec3 point_mm = Vec3::Zero();
};
// Grabs one vertex of the body. An earlier grab is released.
struct GrabVertex {
    int vertex = 0;
};
// Moves the hand to target_mm: at once, or evenly over the simulated time that is given, of which
// a recording holds each step as a move at once. Does nothing where nothing is grabbed.
struct MoveGrab {
    Vec3 target_mm = Vec3::Zero();
    std::optional<double> over_s{};  // > 0, at most longest_move_s
};
inline constexpr double longest_move_s = 1.0;
struct ReleaseGrab {};

// A tool comes towards the point from outside, until it is about to touch something. Replaces a
// tool that is there. See ToolChoice.
struct AddTool {
    std::string kind = "sphere";  // sphere, capsule, forceps or hook
    double radius_mm = 3.0;
    double length_mm = 0.0;
    Vec3 direction = Vec3::UnitZ();
    Vec3 point_mm = Vec3::Zero();
    std::optional<Vec3> side{};
};
// Where the tool's centre is led: a share of the way from where it is led now to the target; or the
// whole way, evenly over the time that is given, as of MoveGrab. Without a tool this and the next
// do nothing.
struct MoveTool {
    Vec3 target_mm = Vec3::Zero();
    double share = 1.0;              // 0 to 1
    std::optional<double> over_s{};  // > 0, at most longest_move_s; then the share is 1
};
// It is led that much further than now.
struct ShiftTool {
    Vec3 by_mm = Vec3::Zero();
};
struct RemoveTool {};
// It is turned that much further about its centre: along the axis, as long as the angle in radians.
struct TurnTool {
    Vec3 by_rad = Vec3::Zero();
};
// The forceps' jaws are led a share of the way from how far they are to open now: to closed, or to
// wide open.
struct CloseForceps {
    double share = 1.0;  // 0 to 1
};
struct OpenForceps {
    double share = 1.0;  // 0 to 1
};
// Builds what tools need in a scene that has not named them, or lets go of it and of a tool.
struct UseTools {
    bool on = true;
};
// What touches beside tools: the vessels each other, and the liver's wall and the tumours, as far
// as the case knows them. Where that is another than before, the vessels go back to rest and are
// whole again, without hand and tool.
struct UseContact {
    bool self = true;
    bool obstacles = false;
    double friction = 0.0;  // Coulomb's coefficient of vessels among each other, 0 to 10
};

// Lowers the strength of the vessel along a line: all that lies between the places nearest to its
// ends, on the way along the tree from one to the other; the section across where they are one.
// In a scene that does not tear, this and the next are refused.
struct CutLine {
    Vec3 from_mm = Vec3::Zero();
    Vec3 to_mm = Vec3::Zero();
    double strength = 0.0;  // 0 to 1, of what it was
};
// Lets the vessels tear in a scene that has not said so, or makes them whole again and stops that.
struct UseTear {
    bool on = true;
    double tear_factor = 1.0;  // > 0, of the tissue's strength
};
// A blade that goes from one point to another, across the vessel that is nearest to its way, and
// cuts through it as far as it goes.
struct Blade {
    Vec3 from_mm = Vec3::Zero();
    Vec3 to_mm = Vec3::Zero();
};

// Injects at the point of the deformed tree nearest to point_mm. An earlier injection is replaced;
// the drug's clock starts at zero and runs. The injection of a drug that does not flow like blood
// is computed on another thread, and shown by FinishInjection.
struct InjectDrug {
    Vec3 point_mm = Vec3::Zero();
    double mass_flow_g_s = default_injection::mass_flow_g_s;     // > 0
    double void_fraction = default_injection::void_fraction;     // volume share, 0 to below 1
    std::string second_phase = default_injection::second_phase;  // gas, lipiodol or carrier
    std::string pressure_model =
        default_injection::pressure_model;        // published, consistent, regime
    std::optional<double> drug_viscosity_pa_s{};  // > 0; otherwise the fluid's own
};
// Shows the injection that is being computed on another thread and starts its clock. Waits where
// the computation has not ended. The session gives this command itself as soon as the computation
// ends; scripts and replays give it at a fixed step, so that the result does not depend on the
// machine's speed. Does nothing where nothing is being computed.
struct FinishInjection {};
struct RemoveDrug {};
struct PlayDrug {
    bool playing = true;
};
struct SetDrugTime {
    double time_s = 0.0;  // >= 0
};
struct SetDrugSpeed {
    double factor = 1.0;  // drug seconds per simulated second, > 0
};

struct SetGravity {
    Vec3 gravity_mm_per_s2 = Vec3::Zero();
};
// Tissue around the vessels as springs to the rest shape.
struct SetTether {
    double pa_per_mm2 = 0.0;  // force per volume per millimetre of displacement, >= 0
};
// Thickness of the vessels' wall: 0 solid, otherwise thinnest_wall_mm to thickest_wall_mm of
// core/scene/scene_spec.h.
struct SetWall {
    double wall_mm = 0.0;
};
// The dial: 0 fastest, 1 most accurate. Ends automatic quality.
struct SetQuality {
    double quality = 0.5;
};
// Whether the session itself chooses the most accurate setting that fits the frame's budget.
struct SetAutomaticQuality {
    bool automatic = true;
};
// Uses exactly this setting. The recording holds this command for every change of the setting, by a
// person or by the session, because the settings that a dial offers differ between machines.
struct UseSetting {
    StepperOptions setting;
};
// Stops or resumes simulated time. Pictures are still drawn and commands still applied.
struct SetPaused {
    bool paused = true;
};
// Returns to the rest shape, without grab and drug. Steps are counted on.
struct ResetWorld {};
// Returns to the last good state, at most a second old, and goes on from there. Settings made since
// then are kept, a grab released since then stays released, and a tool removed since then stays
// away.
struct RestoreSnapshot {};

using Command =
    std::variant<GrabPoint, GrabVertex, MoveGrab, ReleaseGrab, InjectDrug, RemoveDrug, PlayDrug,
                 SetDrugTime, SetDrugSpeed, SetGravity, SetTether, SetQuality, SetPaused,
                 ResetWorld, RestoreSnapshot, SetAutomaticQuality, UseSetting, SetWall,
                 FinishInjection, AddTool, MoveTool, ShiftTool, RemoveTool, TurnTool, UseTools,
                 CloseForceps, OpenForceps, CutLine, Blade, UseTear, UseContact>;

// {"command": "grab_point", "point_mm": [1, 2, 3]}, and back; every number is kept to the last bit.
// Reading throws InputError that names the command and the field that is missing or out of range.
nlohmann::ordered_json to_json(const Command& command);
Command command_from_json(const nlohmann::ordered_json& json);

// The keys of its fields, those that may be left out among them.
std::vector<std::string> field_names(const Command& command);

}  // namespace hepatica
