// SPDX-License-Identifier: GPL-3.0-or-later
// Refuses noise that was taken for vessels by the length of its skeleton, before the steps that
// take minutes on such a tangle.
#pragma once

#include "core/base/job.h"
#include "core/image/volume.h"

namespace hepatica {

// Throws InputError as require_plausible_length() (core/tree/tree_extraction.h) where the pieces of
// this skeleton that are as long as those of a tree are more than 80 m long together, which is
// twice what is refused once the tree is made: spurs still count here. The length is a lower bound,
// the number of voxels times their shortest edge. Throws Cancelled.
void require_plausible_skeleton(const Mask& skeleton, const Job& job);

}  // namespace hepatica
