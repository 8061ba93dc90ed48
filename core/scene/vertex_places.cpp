// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/vertex_places.h"

#include <algorithm>
#include <limits>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/tree/extraction/centreline_locator.h"

namespace hepatica {

namespace {

// The point on a segment's centreline nearest to a position.
TreePoint on_segment(const VesselSegment& segment, int id, const Vec3& position_mm) {
    TreePoint best{id, 0.0, std::numeric_limits<double>::infinity()};
    double start_mm = 0.0;
    for (std::size_t i = 1; i < segment.points_mm.size(); ++i) {
        const Vec3& from = segment.points_mm[i - 1];
        const Vec3 edge = segment.points_mm[i] - from;
        const double share =
            std::clamp((position_mm - from).dot(edge) / edge.squaredNorm(), 0.0, 1.0);
        const double distance_mm = (from + share * edge - position_mm).norm();
        if (distance_mm < best.distance_mm)
            best = {id, start_mm + share * edge.norm(), distance_mm};
        start_mm += edge.norm();
    }
    return best;
}

double widest_radius_mm(const VesselTree& tree) {
    double widest = 0.0;
    for (const VesselSegment& segment : tree.segments)
        widest = std::max(widest, *std::ranges::max_element(segment.radii_mm));
    return widest;
}

}  // namespace

std::vector<VertexPlace> places_of(const std::vector<Vec3>& vertices_mm, const VesselTree& tree) {
    if (tree.segments.empty())
        throw InputError("the vessel tree has no segments", "", "Reconstruct the patient first");
    const CentrelineLocator locator(tree);
    const double reach_mm = 2.0 * widest_radius_mm(tree);
    std::vector<VertexPlace> places(vertices_mm.size());
    constexpr std::size_t block = 256;
    parallel_blocks(vertices_mm.size(), block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t v = begin; v < end; ++v) {
            const auto nearest = locator.nearest(vertices_mm[v], reach_mm);
            const int id = nearest ? nearest->segment : nearest_point(tree, vertices_mm[v]).segment;
            places[v].on_tree = on_segment(tree.segments[id], id, vertices_mm[v]);
            places[v].radius_mm = nearest ? nearest->radius_mm : tree.segments[id].radii_mm.front();
        }
    });
    return places;
}

}  // namespace hepatica
