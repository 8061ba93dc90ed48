// SPDX-License-Identifier: GPL-3.0-or-later
// What is known of one vascular system of a patient: an expert's voxels, or a phantom's own tree.
#pragma once

#include <optional>
#include <vector>

#include "core/accuracy/centreline_samples.h"
#include "core/base/job.h"
#include "core/image/volume.h"
#include "core/tree/vessel_tree.h"

namespace hepatica {

struct SystemTruth {
    VascularSystem system = VascularSystem::portal;
    Mask mask;        // not zero: lumen of this system
    VesselTree tree;  // its centrelines; without segments: those of the mask's skeleton
};

// The centrelines of a mask: its unit-width skeleton without what bumps of the wall add to it (end
// branches that reach less than half a radius of their parent beyond the parent's wall). Isolated
// voxels are left out, gaps stay. Directed from the widest end of each piece; in no system.
VesselTree centrelines_of(const Mask& mask, Job& job);

// Judged samples from an end of a centreline inwards, along its segment, up to reach_mm from it.
std::vector<int> last_of_run(const CentrelineSamples& line, int end, double reach_mm);

// The widest end of the judged part of a tree's centrelines: where a trunk ends, or leaves the
// judged region. An end is a judged sample with at most one judged neighbour; its width is the
// median radius of the last 10 mm of its segment. None where there are no ends.
std::optional<int> widest_end(const CentrelineSamples& line);

}  // namespace hepatica
