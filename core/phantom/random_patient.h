// SPDX-License-Identifier: GPL-3.0-or-later
// A random synthetic patient (domain randomisation, Tobin et al., IROS 2017): contrast, tissue,
// noise, kernel and slices vary more than in real scans, so that a model trained on many of them
// has seen what a real one may show.
#pragma once

#include <cstdint>

#include "core/phantom/phantom.h"

namespace hepatica {

// The same seed gives the same patient. In an adult's size: portal contrast of 20 to 110 HU,
// hepatic veins at 0.3 to 1.1 of it, noise of 5 to 30 HU, slices 0.7 to 5 mm apart, up to eight
// contacts between portal and hepatic veins, arteries in about half of the patients.
PhantomOptions random_patient(std::uint64_t seed);

// A liver mask as a reader might draw it in a hurry: the border moved by up to 2 mm and rippled
// with a standard deviation of 1 mm. On the same grid. Throws Cancelled.
Mask sloppy_liver(const Mask& liver, std::uint64_t seed, Job& job);

}  // namespace hepatica
