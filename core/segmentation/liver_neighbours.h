// SPDX-License-Identifier: GPL-3.0-or-later
// Organs that look like the liver and touch it: spleen, pancreas with duodenum, heart. What tells
// them is that a neck joins them to the liver, and where they lie.
#pragma once

#include "core/base/job.h"
#include "core/image/volume.h"

namespace hepatica {

// What of `parenchyma` is no liver. `seat` is the deepest part of the right lobe, in whose middle
// places begin:
// - lobes (organ_lobes.h) of 8 ml and more, more than 40 mm to the left of it and at least 15 mm
//   further behind than above it (spleen, pancreas; the left lobe lies in front or above), or more
//   than 20 mm to the left and 55 mm above it (heart), and what hangs on them;
// - of what lies like the first kind by 25 mm, all that is thinner than 28 mm (pancreas, duodenum,
//   cava).
// `enclosed`: what fills holes of the parenchyma (enclosed_tissue.h), so that they make no necks.
// All on one grid, whose axes in space are LPS. Throws Cancelled.
Mask neighbours_in(const Mask& parenchyma, const Mask& enclosed, const Mask& seat, Job& job);

}  // namespace hepatica
