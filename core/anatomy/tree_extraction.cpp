// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/anatomy/tree_extraction.h"

#include <algorithm>
#include <limits>

#include "core/anatomy/lumen_radius.h"
#include "core/anatomy/skeleton_graph.h"
#include "core/anatomy/spur_pruning.h"
#include "core/anatomy/system_assignment.h"
#include "core/anatomy/vessel_graph.h"
#include "core/base/error.h"
#include "core/base/parallel.h"

namespace hepatica {

namespace {

// The staircase of voxels becomes a curve with points a voxel apart.
void smooth_link(VesselLink& link, double voxel_mm) {
    Centreline curve{smooth_curve(link.points_mm, 1.5 * voxel_mm, true), link.radii_mm};
    curve = resampled(curve, voxel_mm);
    link.points_mm = std::move(curve.points_mm);
    link.radii_mm = std::move(curve.radii_mm);
}

// Replaces the inscribed radii of a link by area-equivalent ones and moves its points to the middle
// of their cross-sections.
void measure_link(VesselLink& link, const Mask& vessels, double voxel_mm) {
    const std::vector<Vec3> directions = tangents(link.points_mm, 3.0 * voxel_mm);
    const std::size_t n = link.points_mm.size();
    std::vector<double> radii(n), weights(n);
    std::vector<Vec3> centred = link.points_mm;
    for (std::size_t i = 0; i < n; ++i) {
        const double inscribed_mm = link.radii_mm[i];
        const CrossSection section = mask_cross_section(vessels, link.points_mm[i], directions[i],
                                                        2.0 * inscribed_mm + 2.0 * voxel_mm);
        const bool usable = section.radius_mm > 0.0;
        radii[i] = usable ? section.radius_mm : inscribed_mm;
        weights[i] = usable ? section.roundness * section.roundness + 1e-3 : 1e-3;
        if (usable && section.roundness > 0.5 && i > 0 && i + 1 < n)
            centred[i] += section.offset_mm;
    }
    link.points_mm = smooth_curve(centred, 2.0 * voxel_mm, true);
    link.radii_mm = smooth_values(link.points_mm, radii, weights, 3.0 * voxel_mm);
}

RootWish nearest_end(const VesselGraph& graph, const Vec3& position_mm) {
    const auto at_node = links_of_nodes(graph);
    RootWish nearest;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t n = 0; n < graph.nodes.size(); ++n) {
        const double d = (graph.nodes[n].position_mm - position_mm).norm();
        if (at_node[n].size() != 1 || d >= least) continue;
        least = d;
        nearest = {static_cast<int>(n), graph.links[at_node[n][0]].system};
    }
    return nearest;
}

}  // namespace

VesselTree extract_tree(const Mask& skeleton, const Mask& vessels, const Volume*,
                        const TreeOptions& options, Job& job) {
    if (!same_grid(skeleton.grid, vessels.grid))
        throw InputError("the skeleton and the vessel mask lie on different grids", "",
                         "Make the skeleton from this mask");
    job.throw_if_cancelled();
    const double voxel_mm = skeleton.grid.spacing_mm.minCoeff();
    VesselGraph graph = skeleton_graph(skeleton, vessels);
    prune_spurs(graph, options.spur_radii, 1.5 * voxel_mm);
    remove_short_components(graph, options.minimum_component_mm);
    job.advance(0.3);
    parallel_blocks(graph.links.size(), 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            job.throw_if_cancelled();
            smooth_link(graph.links[i], voxel_mm);
            measure_link(graph.links[i], vessels, voxel_mm);
        }
    });
    if (!options.seeds.empty()) assign_systems(graph, options.seeds);
    std::vector<RootWish> wishes;
    for (const Vec3& position : options.roots_mm) wishes.push_back(nearest_end(graph, position));
    VesselTree tree = directed(std::move(graph), wishes);
    job.advance(1.0);
    return tree;
}

}  // namespace hepatica
