// SPDX-License-Identifier: GPL-3.0-or-later
// Organs that look like the liver and touch it: spleen, pancreas with duodenum, heart. They are
// recognised by the neck that joins them to the liver and by their position.
#pragma once

#include "core/base/job.h"
#include "core/image/volume.h"

namespace hepatica {

// The voxels of `parenchyma` and `enclosed` that belong to other organs. Positions are relative to
// the centre of `seat`, the deepest part of the right lobe:
// - lobes (organ_lobes.h) of at least 8 ml that lie more than 40 mm to the left and whose distance
//   behind minus distance above exceeds 15 mm (spleen, pancreas; the left lobe lies in front or
//   above), or that lie more than 20 mm to the left and 55 mm above (heart);
// - lobes of any size joined to one of these, if more than 40 mm to the left;
// - parenchyma thinner than 28 mm that lies more than 40 mm to the left, with 25 mm instead of 15
//   (pancreas, duodenum, cava).
// `enclosed` fills holes of the parenchyma (enclosed_tissue.h), so that they do not look like
// necks. All on one grid, whose axes in space are LPS. Throws Cancelled.
Mask neighbours_in(const Mask& parenchyma, const Mask& enclosed, const Mask& seat, Job& job);

}  // namespace hepatica
