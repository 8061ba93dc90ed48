// SPDX-License-Identifier: GPL-3.0-or-later
// Bodies for the suite of touch: vessel trees bent at random, and a vessel that is a knot.
#pragma once

#include <cstdint>
#include <random>

#include "core/tree/vessel_tree.h"

namespace hepatica {

// The same numbers on every machine, in [low, high).
double uniform(std::mt19937_64& random, double low, double high);

// A study_tree of 1 to 4 generations, all of it bent by smooth waves longer than its branches.
VesselTree random_study_tree(std::mt19937_64& random);

// One vessel along a trefoil that is open at one place, of radius_mm, some 70 mm long.
VesselTree open_knot(double radius_mm);

}  // namespace hepatica
