// SPDX-License-Identifier: GPL-3.0-or-later
// The liver as the region that vessels are looked for in: found in a CT without any mask (seeded
// growth in smoothed Hounsfield units, the largest soft organ), or closed where one is given.
#pragma once

#include "core/base/job.h"
#include "core/image/volume.h"

namespace hepatica {

// A good enough liver, on the grid of the CT: it need not be exact at its border, but it holds the
// liver's vessels and leaves out heart, kidneys, spleen, bone and gut as far as intensity and shape
// tell. Works on voxels of about 3 mm. Throws InputError if the CT shows no organ of that kind, or
// one that bone or lungs enclose (organ_surroundings.h);
// Cancelled.
Mask find_liver(const Volume& ct, Job& job);

// Expert liver masks often have their vessels carved out: closes channels up to twice radius_mm
// wide and fills cavities. Same grid; a superset of the mask.
Mask close_liver(const Mask& liver, double radius_mm, Job& job);

}  // namespace hepatica
