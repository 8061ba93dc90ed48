// SPDX-License-Identifier: GPL-3.0-or-later
// What lies around a soft organ, which tells a liver from a brain in its skull and from a heart
// between the lungs.
#pragma once

#include "core/base/job.h"
#include "core/image/volume.h"

namespace hepatica {

// Shares of what lies within 12 mm around the organ, inside the image.
struct OrganSurroundings {
    double bone = 0.0;  // above 250 HU
    double lung = 0.0;  // -950 to -400 HU
};

// `hu`: the scan, smoothed or not, on the organ's grid. 0 of everything around an organ that fills
// the image. Throws Cancelled, and InputError where there is no organ.
OrganSurroundings surroundings_of(const Mask& organ, const FloatVolume& hu, Job& job);

// Throws InputError that says what the scan seems to show instead, where it is no liver.
void require_surroundings_of_liver(const OrganSurroundings& around);

}  // namespace hepatica
