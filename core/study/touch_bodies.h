// SPDX-License-Identifier: GPL-3.0-or-later
// Bodies for the touch campaign: vessel trees bent at random, and a vessel along a knot.
#pragma once

#include <cstdint>
#include <random>

#include "core/tree/vessel_tree.h"

namespace hepatica {

// A uniform random number in [low, high), the same on every machine.
double uniform(std::mt19937_64& random, double low, double high);

// A study_tree() of 1 to 4 generations, bent by smooth waves longer than its branches.
VesselTree random_study_tree(std::mt19937_64& random);

// One vessel of this radius along a trefoil knot that is open at one place, 104 mm long.
VesselTree open_knot(double radius_mm);

}  // namespace hepatica
