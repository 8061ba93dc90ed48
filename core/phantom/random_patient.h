// SPDX-License-Identifier: GPL-3.0-or-later
// A synthetic patient drawn at random (domain randomisation, Tobin et al. 2017): contrast, tissue,
// noise, kernel and slices vary further than those of real scans are known to, so that what is
// learned on many of them has seen what a real one may show.
#pragma once

#include <cstdint>

#include "core/phantom/phantom.h"

namespace hepatica {

// The same seed gives the same patient. In an adult's size: portal contrast of 20 to 110 HU,
// hepatic veins at 0.3 to 1.1 of it, noise of 5 to 30 HU, slices 0.7 to 5 mm apart, portal and
// hepatic veins that touch in up to eight places, arteries in every other patient.
PhantomOptions random_patient(std::uint64_t seed);

// A liver as a reader might draw it in a hurry: its border off by up to some 3 mm, with a few
// millimetres of ripple. Same grid.
Mask sloppy_liver(const Mask& liver, std::uint64_t seed, Job& job);

}  // namespace hepatica
