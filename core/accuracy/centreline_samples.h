// SPDX-License-Identifier: GPL-3.0-or-later
// The centrelines of a tree as evenly spaced samples, each of which stands for a length, and the
// steps between them. Shares of length, pieces and joins are counted on them.
#pragma once

#include <utility>
#include <vector>

#include "core/image/volume.h"
#include "core/tree/vessel_tree.h"

namespace hepatica {

// A shorter stretch of a centreline says nothing: it may stray that far where lumens touch.
inline constexpr double usual_stray_mm = 5.0;

struct CentrelineSample {
    Vec3 position_mm = Vec3::Zero();
    double radius_mm = 0.0;  // of the lumen there
    double weight_mm = 0.0;  // half of the steps beside it along its segment
    int segment = -1;
    bool judged = true;  // lies in the judged region
};

struct CentrelineStep {
    int from = -1, to = -1;  // samples
    double length_mm = 0.0;  // 0 where two segments meet in a node
};

struct CentrelineSamples {
    std::vector<CentrelineSample> samples;  // segment by segment, from its proximal node
    std::vector<CentrelineStep> steps;
    std::vector<std::pair<int, int>> of_segment;  // first sample and one past the last

    // The sample of a segment that lies nearest to a position. Linear in the segment's samples.
    int nearest(int segment, const Vec3& position_mm) const;
};

// Samples a tree about every step_mm > 0. A sample is judged where `judged` is not zero, nowhere
// outside its grid, and everywhere where it is null.
CentrelineSamples sampled(const VesselTree& tree, double step_mm, const Mask* judged);

// Whether the voxel at a position is not zero; false outside the grid.
bool holds(const Mask& mask, const Vec3& position_mm);

}  // namespace hepatica
