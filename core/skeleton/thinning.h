// SPDX-License-Identifier: GPL-3.0-or-later
// Thinning of a vessel mask to its skeleton, keeping components, tunnels and cavities: the first
// step of section II.A.2 of the paper.
#pragma once

#include "core/base/job.h"
#include "core/image/volume.h"

namespace hepatica {

enum class ThinningMethod {
    // Six directional sub-iterations over a queue of border voxels, every one tested again as a
    // simple point before it goes. Nothing removable is left. See queue_thinning.h.
    queue,
    // The fully parallel templates of the paper's reference: two voxels wide in places, which the
    // unit-width skeleton mends. See parallel_thinning.h.
    parallel,
};

// The skeleton as a mask of 0 and 1 on the same grid. Line ends are kept, isolated voxels too. The
// skeleton may still be more than one voxel wide at junctions: see unit_width_skeleton.h.
// Deterministic; throws Cancelled.
Mask thin(const Mask& mask, ThinningMethod method, Job& job);

}  // namespace hepatica
