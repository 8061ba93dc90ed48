// SPDX-License-Identifier: GPL-3.0-or-later
// The truth about one vascular system of a patient: an expert's voxels, or the tree of a phantom.
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
    VesselTree tree;  // its centrelines; empty: those of the mask's skeleton
};

// The centrelines of a mask: its unit-width skeleton without spurs (end branches that reach less
// than half a radius of their parent, or 1.5 voxels, beyond the parent's wall). Isolated voxels are
// left out, gaps stay. Directed from the widest end of each piece; the system is unknown. Throws
// Cancelled.
VesselTree centrelines_of(const Mask& mask, Job& job);

// The judged samples from an end of a centreline inwards along its segment, the end first, up to
// reach_mm from it.
std::vector<int> last_of_run(const CentrelineSamples& line, int end, double reach_mm);

// The widest end of the judged centrelines: where a trunk ends or leaves the judged region. An end
// is a judged sample with at most one judged neighbour; its width is the median radius over the 10
// mm of its segment next to it. None where there is no end.
std::optional<int> widest_end(const CentrelineSamples& line);

}  // namespace hepatica
