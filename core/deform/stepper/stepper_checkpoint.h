// SPDX-License-Identifier: GPL-3.0-or-later
// Everything except body and options that determines later steps: a stepper with the same body and
// options that restores a checkpoint makes the same steps, to the last bit, as the one that it was
// taken from. A factor or preconditioner is not stored, but recomputed from the inputs of its
// matrix. Taking a checkpoint costs a copy of a few arrays.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/vector.h"
#include "core/deform/body/body_state.h"
#include "core/deform/body/material.h"
#include "core/deform/potentials/self_load.h"
#include "core/deform/potentials/tool.h"
#include "core/deform/step/solver_checkpoint.h"
#include "core/deform/stepper/stepper.h"
#include "core/tear/tear_state.h"

namespace hepatica {

// The live part of the tree, with one entry per skeleton node.
struct RegionCheckpoint {
    std::vector<std::uint8_t> live;  // 0 or 1
    std::vector<double> still_s;
    std::vector<int> held;  // skeleton nodes
    std::vector<Vec3> reference_mm;
};

// A tool beside the body.
struct ToolCheckpoint {
    Tool tool;
    bool led = false;           // it is moving
    ToolLoad last_load;         // of the last step
    double last_contact = 0.0;  // of the last step [nJ]
};

// Contact between the body's own surfaces.
struct SelfCheckpoint {
    OverlapsKept overlaps;
    SelfLoad last_load;         // of the last step
    double last_contact = 0.0;  // of the last step [nJ]
};

// Contact with obstacles.
struct ObstacleCheckpoint {
    SelfCheckpoint touch;
    Vec3 last_force_un = Vec3::Zero();  // of the last step, as is the next
    Vec3 last_impulse_un_s = Vec3::Zero();
};

struct StepperCheckpoint {
    BodyState nodes;  // vertices, then mid-edge nodes
    std::vector<Grab> grabs;
    Vec3 gravity_mm_per_s2 = Vec3::Zero();
    double unreported_tool_work = 0.0;  // nJ, since the last step
    double unreported_loss = 0.0;       // nJ, kinetic energy of nodes frozen since the last step
    double still_s = 0.0;               // see GovernedStepper
    double settled_s = 0.0;             // see GovernedStepper
    double last_kinetic = 0.0;          // nJ, energies of the last step, reported during sleep
    double last_elastic = 0.0;
    double last_grab = 0.0;
    double last_tether = 0.0;
    SolverCheckpoint solver;
    std::optional<RegionCheckpoint> region;         // of a stepper with a live region
    std::optional<ToolCheckpoint> tool{};           // where there is a tool
    std::optional<SelfCheckpoint> self{};           // where surfaces touch each other
    std::optional<TearState> tear{};                // where the body may tear
    std::optional<ObstacleCheckpoint> obstacles{};  // where there are obstacles
    double swing_mm_per_s = 0.0;                    // see SwingSubsteps; >= 0
};

// Hash of the bytes that to_bytes() writes after its heading.
std::uint64_t hash_of(const StepperCheckpoint& checkpoint);

// "hepatica checkpoint 4\n", then the fields in the order above, little-endian: numbers as 8 bytes
// (doubles as IEEE 754, integers signed), elements of `live` and `held` as one byte each; arrays
// after their length; an optional field after a length of 0 or 1. Optional groups follow at the end
// in this order: tools, surfaces, tear, obstacles with the start of the last matrix' step,
// couplings, swing, thin pads of tools, tears of surfaces. The last group in use and those before
// it are written, later ones are not.
std::string to_bytes(const StepperCheckpoint& checkpoint);

// Throws InputError where the bytes are not a checkpoint, are cut off or too long, or hold a number
// that is not finite. Whether it fits a body is checked by Stepper::restore.
StepperCheckpoint checkpoint_from_bytes(std::string_view bytes);

}  // namespace hepatica
