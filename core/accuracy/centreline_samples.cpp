// SPDX-License-Identifier: GPL-3.0-or-later
// Resamples the segments of a tree evenly and links the samples that meet at a node.
#include "core/accuracy/centreline_samples.h"

#include <cmath>

#include "core/tree/extraction/centreline.h"

namespace hepatica {

namespace {

void append_segment(CentrelineSamples& all, const VesselTree& tree, int id, double step_mm,
                    const Mask* judged) {
    const VesselSegment& segment = tree.segments[id];
    const Centreline even = resampled({segment.points_mm, segment.radii_mm}, step_mm);
    const int first = static_cast<int>(all.samples.size());
    for (std::size_t i = 0; i < even.points_mm.size(); ++i) {
        const Vec3& p = even.points_mm[i];
        all.samples.push_back(
            {p, even.radii_mm[i], 0.0, id, judged == nullptr || holds(*judged, p)});
        if (i == 0) continue;
        const int here = static_cast<int>(all.samples.size()) - 1;
        const double length = (p - even.points_mm[i - 1]).norm();
        all.steps.push_back({here - 1, here, length});
        all.samples[here - 1].weight_mm += length / 2.0;
        all.samples[here].weight_mm += length / 2.0;
    }
    all.of_segment.emplace_back(first, static_cast<int>(all.samples.size()));
}

}  // namespace

bool holds(const Mask& mask, const Vec3& position_mm) {
    return value_at(mask, position_mm) != 0;
}

int CentrelineSamples::nearest(int segment, const Vec3& position_mm) const {
    const auto [first, end] = of_segment[segment];
    int best = first;
    for (int i = first + 1; i < end; ++i)
        if ((samples[i].position_mm - position_mm).squaredNorm() <
            (samples[best].position_mm - position_mm).squaredNorm())
            best = i;
    return best;
}

CentrelineSamples sampled(const VesselTree& tree, double step_mm, const Mask* judged) {
    CentrelineSamples all;
    std::vector<int> at_node(tree.nodes.size(), -1);
    for (std::size_t id = 0; id < tree.segments.size(); ++id) {
        append_segment(all, tree, static_cast<int>(id), step_mm, judged);
        const auto [first, end] = all.of_segment.back();
        for (const auto& [node, sample] : {std::pair{tree.segments[id].proximal_node, first},
                                           std::pair{tree.segments[id].distal_node, end - 1}}) {
            if (at_node[node] < 0)
                at_node[node] = sample;
            else
                all.steps.push_back({at_node[node], sample, 0.0});
        }
    }
    return all;
}

}  // namespace hepatica
