// SPDX-License-Identifier: GPL-3.0-or-later
// Whether the liver lies where it should, on the patient's right. An image that was mirrored by an
// export, or that says wrongly how the patient lies, looks plausible otherwise.
#pragma once

#include "core/base/job.h"
#include "core/image/volume.h"

namespace hepatica {

// True where the middle of the liver (organ_label::liver) lies on the left of the middle of what is
// denser than air in the slices of the CT that show it, by a tenth of that width at least. The
// grids may differ. False without a liver. Throws Cancelled.
bool lies_on_the_left(const Mask& organs, const Volume& ct, const Job& job);

}  // namespace hepatica
