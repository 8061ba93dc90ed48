// SPDX-License-Identifier: GPL-3.0-or-later
// The border of an organ as a surface of least weighted area: geodesic active contours in the
// convex form of Bresson et al. (J Math Imaging Vis 2007;28:151), solved by Chambolle and Pock
// (2011).
#pragma once

#include "core/base/job.h"
#include "core/image/volume.h"

namespace hepatica {

// The two costs of a border, on one grid. The unit is the area of one face of a cube with the
// volume of a voxel.
struct BorderCost {
    FloatVolume inside;  // of a voxel that lies inside; negative: a gain
    FloatVolume area;    // > 0, of a voxel face of surface there; small at edges of the image
};

// The mask that minimises the sum of both costs, starting from `start`; 80 iterations come close to
// the minimum. The border of the image costs nothing. `start` lies on the grid of the costs. Throws
// Cancelled.
Mask fit_border(const BorderCost& cost, const Mask& start, int iterations, Job& job);

}  // namespace hepatica
