// SPDX-License-Identifier: GPL-3.0-or-later
// The border of an organ as a surface of least weighted area: geodesic active contours in the
// convex form of Bresson et al. (J Math Imaging Vis 2007;28:151), solved by Chambolle and Pock
// (2011).
#pragma once

#include "core/base/job.h"
#include "core/image/volume.h"

namespace hepatica {

// What a border costs. All on one grid.
struct BorderCost {
    FloatVolume inside;  // of taking a voxel in, against the area of one face; negative: gained
    FloatVolume area;    // > 0: of a voxel face of surface there, small where the image has an edge
};

// Minimises the sum of both over all masks, beginning at `start`; about so after 80 iterations.
// Throws Cancelled.
Mask fit_border(const BorderCost& cost, const Mask& start, int iterations, Job& job);

}  // namespace hepatica
