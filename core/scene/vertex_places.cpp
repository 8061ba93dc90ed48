// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/vertex_places.h"

#include <algorithm>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/tree/extraction/centreline_locator.h"
#include "core/tree/station.h"

namespace hepatica {

namespace {

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
            const auto [arclength_mm, distance_mm] =
                nearest_station(tree.segments[id], vertices_mm[v]);
            places[v].on_tree = {id, arclength_mm, distance_mm};
            places[v].radius_mm = nearest ? nearest->radius_mm : tree.segments[id].radii_mm.front();
        }
    });
    return places;
}

}  // namespace hepatica
