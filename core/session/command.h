// SPDX-License-Identifier: GPL-3.0-or-later
// Everything that a person or a script can do to the world. Commands are plain values. They are
// queued, applied only between two steps, and written into the recording unchanged.
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
// mouse's ray met it). Releases an earlier grab.
struct GrabPoint {
    Vec3 point_mm = Vec3::Zero();
};
// Grabs one vertex of the body. Releases an earlier grab.
struct GrabVertex {
    int vertex = 0;
};
// Moves the hand to target_mm: at once, or evenly over a simulated time; a recording then has one
// immediate move per step. Does nothing where nothing is grabbed.
struct MoveGrab {
    Vec3 target_mm = Vec3::Zero();
    std::optional<double> over_s{};  // > 0, at most longest_move_s
};
inline constexpr double longest_move_s = 1.0;
// Shifts the hand from where it is, for scripts that do not know the place of a grabbed vertex.
// Does nothing where nothing is grabbed.
struct ShiftGrab {
    Vec3 by_mm = Vec3::Zero();
};
struct ReleaseGrab {};

// Brings a tool towards the point from outside until it is about to touch something. Replaces the
// present tool. See ToolChoice.
struct AddTool {
    std::string kind = "sphere";  // sphere, capsule, forceps or hook
    double radius_mm = 3.0;
    double length_mm = 0.0;
    Vec3 direction = Vec3::UnitZ();
    Vec3 point_mm = Vec3::Zero();
    std::optional<Vec3> side{};
};
// Moves the target of the tool's centre: by a share of the way from the present target to
// target_mm, or the whole way, evenly over a time as in MoveGrab. Without a tool this command and
// ShiftTool do nothing.
struct MoveTool {
    Vec3 target_mm = Vec3::Zero();
    double share = 1.0;              // 0 to 1
    std::optional<double> over_s{};  // > 0, at most longest_move_s; then the share is ignored
};
// Shifts the target of the tool's centre.
struct ShiftTool {
    Vec3 by_mm = Vec3::Zero();
};
struct RemoveTool {};
// Adds a rotation of the tool about its centre: a rotation vector in radians.
struct TurnTool {
    Vec3 by_rad = Vec3::Zero();
};
// Moves the target opening of the forceps' jaws by a share of the way to closed or wide open.
struct CloseForceps {
    double share = 1.0;  // 0 to 1
};
struct OpenForceps {
    double share = 1.0;  // 0 to 1
};
// Builds what tools need in a scene that has not named them, or removes it together with the tool.
struct UseTools {
    bool on = true;
};
// Sets what vessels touch besides tools: each other, and the liver's wall and the tumours, as far
// as the case has them. A change puts the vessels at rest and makes them whole, without hand and
// tool.
struct UseContact {
    bool self = true;
    bool obstacles = false;
    double friction = 0.0;  // Coulomb's coefficient between vessels, 0 to 10
};

// Lowers the strength of a vessel along a line: everything on the way along the tree between the
// places nearest to its ends, or the cross section if these are the same place. Refused in a scene
// that does not tear.
struct CutLine {
    Vec3 from_mm = Vec3::Zero();
    Vec3 to_mm = Vec3::Zero();
    double strength = 0.0;  // 0 to 1, factor on the present strength
};
// Lets the vessels tear in a scene that has not named it, or makes them whole and ends tearing.
struct UseTear {
    bool on = true;
    double tear_factor = 1.0;  // factor on the tissue's strength, see validate_tear_factor
};
// Moves a blade from one point to another across the vessel nearest to its way; it cuts the vessel
// as far as it goes. Refused in a scene that does not tear.
struct Blade {
    Vec3 from_mm = Vec3::Zero();
    Vec3 to_mm = Vec3::Zero();
};

// Injects at the point of the deformed tree nearest to point_mm. Replaces an earlier injection; the
// drug's clock starts at zero and runs. The injection of a drug that does not flow like blood is
// computed on another thread and shown by FinishInjection.
struct InjectDrug {
    Vec3 point_mm = Vec3::Zero();
    double mass_flow_g_s = default_injection::mass_flow_g_s;     // 1e-12 to 1e15
    double void_fraction = default_injection::void_fraction;     // volume share, 0 to below 1
    std::string second_phase = default_injection::second_phase;  // gas, lipiodol or carrier
    std::string pressure_model =
        default_injection::pressure_model;        // published, consistent, regime
    std::optional<double> drug_viscosity_pa_s{};  // > 0; otherwise the fluid's own
};
// Shows the injection that was computed on another thread and starts its clock; waits for the
// computation. Where it was computed again because vessels tore, its clock runs on. The session
// posts this command itself as soon as the computation ends; scripts and replays post it at a fixed
// step, so that the result does not depend on the machine's speed. Does nothing where nothing is
// being computed.
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
// The surrounding tissue as springs to the rest shape.
struct SetTether {
    double pa_per_mm2 = 0.0;  // force per volume per millimetre of displacement, >= 0
};
// Wall thickness of the vessels: 0 solid, otherwise thinnest_wall_mm to thickest_wall_mm of
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
// Uses exactly this setting. The recording has this command for every change of the setting, by a
// person or by the session, because the settings on a dial differ between machines.
struct UseSetting {
    StepperOptions setting;
};
// Stops or resumes simulated time. Pictures are still drawn and commands still applied.
struct SetPaused {
    bool paused = true;
};
// Returns to the rest shape, without grab, tool, tear and drug. Steps keep counting.
struct ResetWorld {};
// Returns to the last good state, at most a second old, and continues from there. Later changes of
// settings are kept; a grab that was released since then stays released, and a tool that was
// removed stays away.
struct RestoreSnapshot {};

using Command =
    std::variant<GrabPoint, GrabVertex, MoveGrab, ReleaseGrab, InjectDrug, RemoveDrug, PlayDrug,
                 SetDrugTime, SetDrugSpeed, SetGravity, SetTether, SetQuality, SetPaused,
                 ResetWorld, RestoreSnapshot, SetAutomaticQuality, UseSetting, SetWall,
                 FinishInjection, AddTool, MoveTool, ShiftTool, RemoveTool, TurnTool, UseTools,
                 CloseForceps, OpenForceps, CutLine, Blade, UseTear, UseContact, ShiftGrab>;

// {"command": "grab_point", "point_mm": [1, 2, 3]}, and back; numbers are exact to the last bit.
// Reading throws InputError that names the command and the field that is missing or out of range,
// with the value and the range (core/session/command_ranges.h).
nlohmann::ordered_json to_json(const Command& command);
Command command_from_json(const nlohmann::ordered_json& json);

// The keys of its fields, including optional ones.
std::vector<std::string> field_names(const Command& command);

}  // namespace hepatica
