// SPDX-License-Identifier: GPL-3.0-or-later
// One step of backward Euler while it is made. Its unknown is the velocity w at the end; positions
// are x_n + dt w.
#pragma once

#include <stop_token>
#include <vector>

#include "core/base/vector.h"
#include "core/deform/body/body_state.h"
#include "core/deform/body/energy_ledger.h"
#include "core/deform/potentials/potential_list.h"

namespace hepatica {

// Works of the whole linearised step along its motion dx, from the slots of the step's start [nJ].
struct LinearisedWork {
    double start_force = 0.0;  // of all forces at the start: f_n . dx
    double curvature = 0.0;    // dx^T (K + stiffness of the potentials) dx: what the equations take
                               // off that
    double residual = 0.0;     // of what the linear solver left unbalanced, and of E
};

struct StepUnderway {
    const PotentialList& potentials;
    const BodyState& start;
    double dt_s;
    EnergyLedger before;              // the energies at the start
    std::vector<Vec3> velocity;       // accepted so far
    std::vector<Vec3> positions;      // x_n + dt velocity
    std::stop_token stop{};           // asks for the end of the step, which then throws Cancelled
    std::vector<Vec3> start_force{};  // elastic and of the potentials, at x_n [uN]
    // Where the first iterate begins: at w = v_n, where the body is on its way, or at w = 0.
    bool predicted = false;
    bool together = false;  // it begins at the velocity of the centre of mass for all nodes
    std::vector<Vec3> damping_force{};  // beta K w, of the velocity; K is that of the first iterate
    double value = 0.0;                 // of the incremental potential at `velocity`
    double standing = 0.0;              // of it at velocity 0
    double damping_form = 0.0;          // velocity . damping_force
    int iterate = 0;
    double step_length = 1.0;  // of the last direction that was taken: 1 is all of it
    double free = 1.0;   // the share of that direction on which nothing passes through anything
    bool whole = false;  // one iterate, taken whole: the linearised equations hold
    LinearisedWork linearised{};
};

}  // namespace hepatica
