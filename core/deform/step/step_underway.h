// SPDX-License-Identifier: GPL-3.0-or-later
// One step of backward Euler in progress. Its unknown is the velocity w at the end; positions are
// x_n + dt w.
#pragma once

#include <stop_token>
#include <vector>

#include "core/base/vector.h"
#include "core/deform/body/body_state.h"
#include "core/deform/body/energy_ledger.h"
#include "core/deform/potentials/potential_list.h"

namespace hepatica {

// Works of the whole linearised step along its motion dx, from the slots at the step's start [nJ].
struct LinearisedWork {
    double start_force = 0.0;  // work of all forces at the start: f_n . dx
    double curvature = 0.0;    // dx^T (K + stiffness of the potentials) dx, which the equations
                               // subtract from it
    double residual = 0.0;     // work of the linear solver's residual, and of E
};

struct StepUnderway {
    const PotentialList& potentials;
    const BodyState& start;
    double dt_s;
    EnergyLedger before;              // the energies at the start
    std::vector<Vec3> velocity;       // accepted so far
    std::vector<Vec3> positions;      // x_n + dt velocity
    std::stop_token stop{};           // on request the step throws Cancelled
    std::vector<Vec3> start_force{};  // elastic and of the potentials, at x_n [uN]
    // Whether the first iterate starts from a moving state (w = v_n) instead of w = 0.
    bool predicted = false;
    bool together = false;  // it starts with the centre of mass's velocity for all nodes
    std::vector<Vec3> damping_force{};  // beta K w with K of the first iterate
    double value = 0.0;                 // of the incremental potential at `velocity`
    double standing = 0.0;              // of the incremental potential at velocity 0
    double damping_form = 0.0;          // velocity . damping_force
    int iterate = 0;
    double step_length = 1.0;  // of the last direction; 1: taken whole
    double free = 1.0;         // share of that direction that passes through nothing
    bool whole = false;        // one iterate, taken whole: the linearised equations hold
    LinearisedWork linearised{};
};

}  // namespace hepatica
