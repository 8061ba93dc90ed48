// SPDX-License-Identifier: GPL-3.0-or-later
// Everything that determines the steps to come, apart from the body's description and the stepper's
// options: a stepper that is made of the same two and given a checkpoint goes on with the same bits
// as the one it was taken from. What a factor or a preconditioner holds is not kept but the inputs
// of the matrix it was made from, so that it can be made anew. Taking one costs a few copied
// arrays.
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
#include "core/deform/stepper/stepper.h"

namespace hepatica {

// The inputs of one system matrix of eq. (12). The matrices of later Newton iterates hold the
// damping of the first.
struct MatrixOrigin {
    double dt_s = 0.0;               // > 0
    std::vector<Vec3> first_mm;      // where the first iterate was
    std::vector<Vec3> iterate_mm;    // empty at the first iterate
    std::vector<std::uint8_t> held;  // per node: fixed or frozen then
    std::vector<Grab> grabs;
    RayleighDamping velocity_error;  // E of eq. (11)
};

// What a linear solver carries from one step to the next.
struct SolverCheckpoint {
    std::optional<MatrixOrigin> made_from;  // its factor or preconditioner; none: it has none yet
    std::vector<double> memory;             // see LinearSolver::memory
};

// The stretches that are computed, one entry per skeleton node.
struct RegionCheckpoint {
    std::vector<std::uint8_t> live;  // 0 or 1
    std::vector<double> still_s;
    std::vector<int> held;  // skeleton nodes
    std::vector<Vec3> reference_mm;
};

struct StepperCheckpoint {
    BodyState nodes;  // middles of edges too
    std::vector<Grab> grabs;
    Vec3 gravity_mm_per_s2 = Vec3::Zero();
    double unreported_tool_work = 0.0;  // nJ, since the last step
    double unreported_loss = 0.0;       // nJ, of motion that freezing ended since
    double still_s = 0.0;               // for how long nothing has moved
    double settled_s = 0.0;             // for how long nothing has moved much
    double last_kinetic = 0.0;          // of the last step [nJ]: what a sleeping body reports
    double last_elastic = 0.0;
    double last_grab = 0.0;
    double last_tether = 0.0;
    SolverCheckpoint solver;
    std::optional<RegionCheckpoint> region;  // where stretches may freeze
};

// Of every field.
std::uint64_t hash_of(const StepperCheckpoint& checkpoint);

// "hepatica checkpoint 2\n", then the fields in the order above, little-endian: numbers as 8 bytes
// (doubles as IEEE 754, integers signed), bytes of `live` and `held` as one each; arrays after
// their length; an optional field after a length of 0 or 1.
std::string to_bytes(const StepperCheckpoint& checkpoint);

// Throws InputError where the bytes are no checkpoint, are cut off or too long, or hold a number
// that is not finite. What does not fit a body is found by Stepper::restore.
StepperCheckpoint checkpoint_from_bytes(std::string_view bytes);

}  // namespace hepatica
