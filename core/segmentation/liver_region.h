// SPDX-License-Identifier: GPL-3.0-or-later
// The liver, and the region in which its vessels are sought. Either found in a CT without a mask
// (parenchyma grown from the deepest part of the largest soft organ, separated from its neighbours,
// with a border of least weighted area), or closed where a mask is given.
#pragma once

#include "core/base/job.h"
#include "core/image/volume.h"

namespace hepatica {

// Both on the grid of the CT.
struct FoundLiver {
    // With the vessels and tumours that it encloses. docs/accuracy.md gives its accuracy on
    // synthetic and real patients. It may include parts of pancreas, cava and heart that touch it
    // without an edge, and miss tumours at its surface and the tip of a left lobe that bends round
    // the spleen.
    Mask liver;
    // Where its vessels are sought: the largest soft organ with all adjacent tissue that looks like
    // it, including spleen and pancreas. The threshold for lines (false_line_threshold.h) depends
    // on the contents of the region; on real patients more of the liver's vessels were found in
    // this region than in the liver alone (docs/accuracy.md).
    Mask vessel_region;
};

// Works on voxels of about 3 mm; the result is resampled to the grid of the CT. Throws
// NoLiverFound (organ_surroundings.h), an InputError, if the CT shows no such organ, or one
// enclosed by bone or lungs; Cancelled.
FoundLiver find_liver(const Volume& ct, Job& job);

// Closes channels up to twice radius_mm wide and fills cavities, because expert liver masks often
// have their vessels carved out. Same grid; a superset of the mask. Throws Cancelled.
Mask close_liver(const Mask& liver, double radius_mm, Job& job);

}  // namespace hepatica
