// SPDX-License-Identifier: GPL-3.0-or-later
// Thinning of a vessel mask to its skeleton, preserving components, tunnels and cavities: the first
// step of section II.A.2 of the paper.
#pragma once

#include "core/base/job.h"
#include "core/image/volume.h"

namespace hepatica {

enum class ThinningMethod {
    // Six directional sub-iterations over a queue of border voxels; each voxel is tested again as a
    // simple point before it is deleted. No deletable voxel remains. See queue_thinning.h.
    queue,
    // The fully parallel templates of the paper's reference. Lines may be two voxels wide, which
    // unit_width() corrects. See parallel_thinning.h.
    parallel,
};

// The skeleton as a mask of 0 and 1 on the same grid. Line ends and isolated voxels are kept. It
// may be more than one voxel wide at junctions: see unit_width_skeleton.h. Deterministic; throws
// Cancelled.
Mask thin(const Mask& mask, ThinningMethod method, Job& job);

}  // namespace hepatica
