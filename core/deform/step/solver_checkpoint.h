// SPDX-License-Identifier: GPL-3.0-or-later
// The state that the step's linear solver carries from one step to the next. A factor or
// preconditioner is not stored, but the inputs of its matrix are, from which it is recomputed to
// the same bits.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/base/vector.h"
#include "core/deform/body/material.h"
#include "core/deform/potentials/grab.h"
#include "core/deform/potentials/self_load.h"
#include "core/deform/potentials/tool.h"
#include "core/deform/solvers/coupled_factor.h"

namespace hepatica {

// The inputs from which one system matrix of eq. (12) is assembled. The matrix of a later Newton
// iterate uses the damping of the first iterate.
struct MatrixOrigin {
    double dt_s = 0.0;             // > 0
    std::vector<Vec3> first_mm;    // positions of the first iterate
    std::vector<Vec3> iterate_mm;  // positions of this iterate; empty: it is the first
    std::vector<Vec3> taut_mm;     // positions at which tension was found; empty: nothing was taut
    bool collapse = false;         // collapsed elements counted
    std::vector<std::uint8_t> held;  // per node: whether it was fixed or frozen
    std::vector<Grab> grabs;
    Vec3 gravity_mm_per_s2 = Vec3::Zero();  // friction depends on all forces
    RayleighDamping velocity_error;         // E of eq. (11)
};

// The tool whose contacts are part of that matrix.
struct ToolOrigin {
    Tool tool;
    std::vector<Vec3> start_mm;  // positions at the start of the step
};

// The state that a linear solver carries from one step to the next.
struct SolverCheckpoint {
    std::optional<MatrixOrigin> made_from{};  // of the factor or preconditioner; none without one
    std::vector<double> memory{};             // see LinearSolver::memory
    std::optional<ToolOrigin> tool{};         // none where the matrix had no tool
    SurfacesKept overlaps{};                  // of that matrix
    std::vector<Vec3> began_mm{};  // start of its step, needed for friction of surfaces; else empty
    CoupledMemory coupled{};       // of the coupled factor; empty where there is none
};

}  // namespace hepatica
