// SPDX-License-Identifier: GPL-3.0-or-later
// What a scene says about tearing: how much a joint bears, what it takes to open it, and when the
// tear stops (the paper's section II.C.2).
#pragma once

#include "core/tear/softening.h"

namespace hepatica {

// When no more joints part:
// - none: as long as something pulls
// - entropy: when the entropy produced since the first split exceeds a budget, eq. (13)
// - vertices: when so many vertices were split off: the conventional way
enum class TearStop { none, entropy, vertices };

struct TearLaw {
    double strength_pa = 1e6;             // > 0: nominal, per area at rest
    double fracture_energy_j_m2 = 164.0;  // > 0; of the area torn
    double tear_factor = 1.0;             // > 0: of the strength, everywhere
    // A bare force limit, as published: a joint whose load reaches its limit has come apart.
    bool bare_limit = false;
    TearStop stop = TearStop::none;
    double entropy_budget_nats = 0.5;  // >= 0
    int vertex_budget = 200;           // >= 0

    SofteningLaw softening() const {
        return {strength_pa, 2e3 * fracture_energy_j_m2 / strength_pa};
    }
};

// Throws InputError that names the value and its range.
void validate(const TearLaw& law);

}  // namespace hepatica
