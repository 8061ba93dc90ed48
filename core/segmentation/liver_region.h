// SPDX-License-Identifier: GPL-3.0-or-later
// The liver as the region that vessels are looked for in: found in a CT without any mask
// (parenchyma grown from the deepest part of the largest soft organ, parted from its neighbours,
// with a border of least weighted area), or closed where one is given.
#pragma once

#include "core/base/job.h"
#include "core/image/volume.h"

namespace hepatica {

// The liver on the grid of the CT, with its vessels but without tumours wider than 18 mm; how good
// it is on synthetic and on real patients says docs/accuracy.md. What it may take in are the parts
// of pancreas, cava and heart that touch it without an edge; what it may miss is the tip of a left
// lobe that bends round the spleen. Works on voxels of about 3 mm. Throws InputError if the CT
// shows no organ of that kind, or one that bone or lungs enclose (organ_surroundings.h); Cancelled.
Mask find_liver(const Volume& ct, Job& job);

// Where vessels are looked for when no liver was given: the largest soft organ with all tissue that
// touches it and looks like it, spleen and pancreas among it. The level above which a line is a
// vessel (false_line_threshold.h) follows what else is in the region; on real patients more of the
// liver's vessels were found in this one than in find_liver()'s alone (docs/accuracy.md). Grid of
// the CT. Throws Cancelled.
Mask vessel_region(const Volume& ct, Job& job);

// Expert liver masks often have their vessels carved out: closes channels up to twice radius_mm
// wide and fills cavities. Same grid; a superset of the mask.
Mask close_liver(const Mask& liver, double radius_mm, Job& job);

}  // namespace hepatica
