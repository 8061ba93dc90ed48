// SPDX-License-Identifier: GPL-3.0-or-later
// The tissue around a soft organ, which distinguishes a liver from a brain in its skull and from a
// heart between the lungs.
#pragma once

#include "core/base/error.h"
#include "core/base/job.h"
#include "core/image/volume.h"

namespace hepatica {

// The CT shows no organ that could be a liver.
class NoLiverFound : public InputError {
    using InputError::InputError;
};

// Shares of the voxels within 12 mm around the organ, inside the image.
struct OrganSurroundings {
    double bone = 0.0;  // above 250 HU
    double lung = 0.0;  // -950 to -400 HU
};

// `hu`: the scan, smoothed or not, on the organ's grid. Both shares are 0 for an organ that fills
// the image. Throws NoLiverFound where the organ is empty; Cancelled.
OrganSurroundings surroundings_of(const Mask& organ, const FloatVolume& hu, Job& job);

// Throws NoLiverFound where the organ is not a liver; the error names what the scan seems to show.
void require_surroundings_of_liver(const OrganSurroundings& around);

}  // namespace hepatica
