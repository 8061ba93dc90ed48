// SPDX-License-Identifier: GPL-3.0-or-later
// The liver, and the region that its vessels are looked for in: found in a CT without any mask
// (parenchyma grown from the deepest part of the largest soft organ, parted from its neighbours,
// with a border of least weighted area), or closed where one is given.
#pragma once

#include "core/base/job.h"
#include "core/image/volume.h"

namespace hepatica {

// Both on the grid of the CT.
struct FoundLiver {
    // With the vessels and tumours that it encloses; how good it is on synthetic and on real
    // patients says docs/accuracy.md. It may take in the parts of pancreas, cava and heart that
    // touch it without an edge, and miss tumours at its surface and the tip of a left lobe that
    // bends round the spleen.
    Mask liver;
    // Where its vessels are looked for: the largest soft organ with all tissue that touches it and
    // looks like it, spleen and pancreas among it. The level above which a line is a vessel
    // (false_line_threshold.h) follows what else is in the region; on real patients more of the
    // liver's vessels were found in this one than in the liver alone (docs/accuracy.md).
    Mask vessel_region;
};

// Works on voxels of about 3 mm. Throws InputError if the CT shows no organ of that kind, or one
// that bone or lungs enclose (organ_surroundings.h); Cancelled.
FoundLiver find_liver(const Volume& ct, Job& job);

// Expert liver masks often have their vessels carved out: closes channels up to twice radius_mm
// wide and fills cavities. Same grid; a superset of the mask.
Mask close_liver(const Mask& liver, double radius_mm, Job& job);

}  // namespace hepatica
