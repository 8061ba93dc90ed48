// SPDX-License-Identifier: GPL-3.0-or-later
// Everything that a person or a script can do to the world. Commands are plain values: they wait in
// a queue, are applied at a step boundary only, and are written into the recording as they are.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <variant>

#include "core/base/vector.h"
#include "core/deform/stepper/stepper_options.h"
#include "core/scene/default_injection.h"

namespace hepatica {

// Takes hold of the body at the point of its present surface nearest to point_mm (for example where
// the mouse's ray met it). Replaces a grab that is held.
struct GrabPoint {
    Vec3 point_mm = Vec3::Zero();
};
// Takes hold of one vertex of the body.
struct GrabVertex {
    int vertex = 0;
};
// Where the hand is now. Without a grab it does nothing.
struct MoveGrab {
    Vec3 target_mm = Vec3::Zero();
};
struct ReleaseGrab {};

// Injects at the point of the tree nearest to point_mm, seen in the present (deformed) shape.
// Replaces an injection that was made before; the drug's clock starts at zero and plays. A drug
// that does not flow like blood is computed beside the play until FinishInjection.
struct InjectDrug {
    Vec3 point_mm = Vec3::Zero();
    double mass_flow_g_s = default_injection::mass_flow_g_s;     // > 0
    double void_fraction = default_injection::void_fraction;     // volume share, 0 to below 1
    std::string second_phase = default_injection::second_phase;  // gas, lipiodol or carrier
    std::string pressure_model =
        default_injection::pressure_model;        // published, consistent, regime
    std::optional<double> drug_viscosity_pa_s{};  // > 0; otherwise the fluid's own
};
// Shows the injection that is being computed (of a drug that does not flow like blood) and starts
// its clock, waiting for it where it is not done. The session gives this command itself as soon as
// the injection is done; scripts and replays give it at a step of theirs, so that they do not
// depend on the machine. Does nothing where nothing is being computed.
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
// Whether the session picks the most accurate setting that the frame's budget allows.
struct SetAutomaticQuality {
    bool automatic = true;
};
// One setting exactly. Whatever changes the setting in play, a person's hand or the session itself,
// stands in the recording as this: what the dial offers differs from machine to machine.
struct UseSetting {
    StepperOptions setting;
};
// Stops and resumes the clock; the view stays alive.
struct SetPaused {
    bool paused = true;
};
// Back to the rest shape: no grab, no drug, step count goes on.
struct ResetWorld {};
// Back to the last good state, a second ago at most, and on. What was set since then stays set, and
// a hand that has opened since stays open.
struct RestoreSnapshot {};

using Command = std::variant<GrabPoint, GrabVertex, MoveGrab, ReleaseGrab, InjectDrug, RemoveDrug,
                             PlayDrug, SetDrugTime, SetDrugSpeed, SetGravity, SetTether, SetQuality,
                             SetPaused, ResetWorld, RestoreSnapshot, SetAutomaticQuality,
                             UseSetting, SetWall, FinishInjection>;

// {"command": "grab_point", "point_mm": [1, 2, 3]} and back; numbers survive to the last bit.
// Reading throws InputError that names the command and the field that is missing or out of range.
nlohmann::ordered_json to_json(const Command& command);
Command command_from_json(const nlohmann::ordered_json& json);

}  // namespace hepatica
