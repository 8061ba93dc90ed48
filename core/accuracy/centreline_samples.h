// SPDX-License-Identifier: GPL-3.0-or-later
// The centrelines of a tree as points at even distances, each of which stands for a length of its
// own, with the steps between them: what shares of length, pieces and joins are counted on.
#pragma once

#include <utility>
#include <vector>

#include "core/image/volume.h"
#include "core/tree/vessel_tree.h"

namespace hepatica {

struct CentrelineSample {
    Vec3 position_mm = Vec3::Zero();
    double radius_mm = 0.0;  // of the lumen there
    double weight_mm = 0.0;  // half the steps beside it
    int segment = -1;
    bool judged = true;  // lies in the region that was given
};

struct CentrelineStep {
    int from = -1, to = -1;  // samples
    double length_mm = 0.0;  // 0 where two segments meet in a node
};

struct CentrelineSamples {
    std::vector<CentrelineSample> samples;  // segment by segment, from its proximal node
    std::vector<CentrelineStep> steps;
    std::vector<std::pair<int, int>> of_segment;  // first sample and one past the last

    // The sample of a segment that lies nearest to a position.
    int nearest(int segment, const Vec3& position_mm) const;
};

// Samples are about step_mm apart. Judged is what lies in the voxels of `judged` that are not zero;
// everything where it is null, nothing outside its grid.
CentrelineSamples sampled(const VesselTree& tree, double step_mm, const Mask* judged);

// Whether the voxel that holds a position is not zero; false outside the grid.
bool holds(const Mask& mask, const Vec3& position_mm);

}  // namespace hepatica
