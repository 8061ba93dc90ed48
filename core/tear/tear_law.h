// SPDX-License-Identifier: GPL-3.0-or-later
// The scene's law of tearing: the strength of a joint, the energy to open it, and when the tear
// stops (section II.C.2 of the paper).
#pragma once

#include "core/tear/softening.h"

namespace hepatica {

// When no more joints part:
// - none: never
// - entropy: when the entropy produced since the first split exceeds a budget, eq. (13)
// - vertices: when a number of vertices has been split off: the conventional way
enum class TearStop { none, entropy, vertices };

struct TearLaw {
    double strength_pa = 1e6;             // > 0: nominal, per rest area
    double fracture_energy_j_m2 = 164.0;  // > 0, per torn area
    double tear_factor = 1.0;             // > 0: multiplies the strength everywhere
    // A plain force limit, as published: a joint whose load reaches its limit comes apart at once.
    bool bare_limit = false;
    TearStop stop = TearStop::none;
    double entropy_budget_nats = 0.5;  // >= 0
    int vertex_budget = 200;           // >= 0

    SofteningLaw softening() const {
        return {strength_pa, 2e3 * fracture_energy_j_m2 / strength_pa};
    }
};

// Throws InputError that names the value and its valid range.
void validate(const TearLaw& law);

}  // namespace hepatica
