// SPDX-License-Identifier: GPL-3.0-or-later
// Runs the extraction: graph, spurs, radii, bridges, systems, loops, trunk, blobs, tree.
#include "core/tree/tree_extraction.h"

#include <algorithm>
#include <iterator>
#include <limits>

#include "core/base/error.h"
#include "core/base/number_text.h"
#include "core/tree/extraction/bridged_points.h"
#include "core/tree/extraction/component_pruning.h"
#include "core/tree/extraction/lumen_measurement.h"
#include "core/tree/extraction/skeleton_graph.h"
#include "core/tree/extraction/spur_pruning.h"
#include "core/tree/extraction/system_assignment.h"
#include "core/tree/extraction/vessel_graph.h"
#include "core/tree/station.h"
#include "core/tree/systems/blob_removal.h"
#include "core/tree/systems/loop_opening.h"
#include "core/tree/systems/portal_trunk.h"

namespace hepatica {

namespace {

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

// 1 in every vessel: radii are measured between voxels, where numbers of systems must not be
// interpolated.
Mask binary(Mask mask) {
    for (std::uint8_t& voxel : mask.voxels) voxel = voxel != 0;
    return mask;
}

void add(RemovedPieces& sum, const RemovedPieces& more) {
    sum.count += more.count;
    sum.length_mm += more.length_mm;
}

std::vector<RootWish> wishes_of(const TreeOptions& options, const VesselGraph& graph) {
    std::vector<RootWish> wishes;
    for (const Vec3& position : options.roots_mm) wishes.push_back(nearest_end(graph, position));
    return wishes;
}

// The portal end nearest to the place where the trunk was seen, within 15 mm.
std::vector<RootWish> trunk_wish(const VesselGraph& graph, const std::optional<Vec3>& trunk_mm) {
    double nearest_mm = 15.0;
    std::vector<RootWish> wish;
    if (!trunk_mm) return wish;
    const auto at_node = links_of_nodes(graph);
    for (std::size_t n = 0; n < graph.nodes.size(); ++n) {
        if (at_node[n].size() != 1) continue;
        const VascularSystem system = graph.links[at_node[n].front()].system;
        const double away = (graph.nodes[n].position_mm - *trunk_mm).norm();
        if (system != VascularSystem::portal || away >= nearest_mm) continue;
        nearest_mm = away;
        wish = {{static_cast<int>(n), system}};
    }
    return wish;
}

// The first wish for a component counts: the user's, then the trunk that was seen, then anatomy's.
std::vector<RootWish> all_wishes(const TreeOptions& options, const VesselGraph& graph,
                                 const AnatomicalAnchors& anchors,
                                 const std::optional<Vec3>& trunk_mm) {
    std::vector<RootWish> wishes = wishes_of(options, graph);
    std::ranges::copy(trunk_wish(graph, trunk_mm), std::back_inserter(wishes));
    std::ranges::copy(anatomical_roots(graph, anchors), std::back_inserter(wishes));
    return wishes;
}

bool belongs_to(const VesselTree& tree, const Vec3& place_mm) {
    if (tree.segments.empty()) return false;
    const TreePoint at = nearest_point(tree, place_mm);
    const VesselSegment& segment = tree.segments[static_cast<std::size_t>(at.segment)];
    return at.distance_mm <= station_at(segment, at.arclength_mm).radius_mm + kept_reach_mm;
}

// Seeds, and the kept places in the tree as seeds that say nothing of a system.
std::vector<VesselSeed> keepers_of(const TreeOptions& options, const VesselTree& tree) {
    std::vector<VesselSeed> keepers = options.seeds;
    for (const Vec3& place : options.kept_mm)
        if (belongs_to(tree, place)) keepers.push_back({place, VascularSystem::unknown});
    return keepers;
}

double length_of_all_mm(const VesselGraph& graph) {
    double all_mm = 0.0;
    for (const VesselLink& link : graph.links) all_mm += length_mm(link);
    return all_mm;
}

void grow_found_systems(VesselGraph graph, const Volume* ct, const TreeOptions& options,
                        const Job& job, TreeExtraction& result) {
    require_plausible_length(length_of_all_mm(graph));
    result.systems = tell_systems_apart(
        graph, ct, {options.seeds, options.liver_mm, options.systems_before}, job);
    const AnatomicalAnchors& anchors = result.systems->anchors;
    std::optional<Vec3> trunk_mm = options.portal_trunk_mm;
    const auto directed_by_wishes = [&](const VesselGraph& made) {
        return directed(made, all_wishes(options, made, anchors, trunk_mm));
    };
    if (trunk_mm) lead_trunk_to(*trunk_mm, graph);
    result.tree = directed_by_wishes(graph);
    OpenedLoops opened = open_loops(result.tree);
    result.opened_loops = opened.count;
    if (opened.count > 0) result.tree = directed_by_wishes(opened.graph);
    const std::vector<VesselSeed> keepers = keepers_of(options, result.tree);
    if (trunk_mm && options.shorten_trunk && options.roots_mm.empty())
        if (const auto trunk = short_trunk(result.tree, *trunk_mm, keepers)) {
            trunk_mm = trunk->begins_mm;
            result.beside_trunk = trunk->beside;
            result.trunk_left_out = trunk->left_out;
            result.tree = directed_by_wishes(trunk->graph);
        }
    // Repeated, because removing a piece can leave others separate.
    while (true) {
        const RemovedPieces blobs = remove_blobs(result.tree, keepers, graph);
        if (blobs.count == 0) break;
        add(result.blobs, blobs);
        result.tree = directed_by_wishes(graph);
    }
}

}  // namespace

void require_plausible_length(double all_mm, double most_mm) {
    if (all_mm <= most_mm) return;
    throw InputError("the vessels found are " + fixed_text(all_mm / 1000.0, 0) +
                         " m long together, more than a liver shows",
                     "vessels",
                     "Noise is taken for vessels: choose a higher threshold, or give a mask of the "
                     "vessels");
}

TreeExtraction extract_tree_and_bridges(const Mask& skeleton, const Mask& vessels, const Volume* ct,
                                        const TreeOptions& options, Job& job) {
    if (!same_grid(skeleton.grid, vessels.grid))
        throw InputError("the skeleton and the vessel mask lie on different grids", "",
                         "Make the skeleton from this mask");
    job.throw_if_cancelled();
    TreeExtraction result;
    const Mask lumen = binary(vessels);
    VesselGraph graph = skeleton_graph(skeleton, lumen);
    prune_spurs(graph, options.spur_radii, 1.5 * skeleton.grid.spacing_mm.minCoeff());
    add(result.too_short,
        remove_short_components(graph, options.minimum_piece_mm, options.seeds, options.kept_mm));
    job.advance(0.3);
    measure_lumen(graph, lumen, ct, [&](double share) { job.advance(0.3 + 0.5 * share); });
    result.bridges = bridge_gaps(graph, lumen, ct, options.bridging,
                                 [&](double share) { job.advance(0.8 + 0.15 * share); });
    if (!options.find_systems) assign_systems(graph, vessels);
    add(result.too_short, remove_short_components(graph, options.minimum_component_mm,
                                                  options.seeds, options.kept_mm));
    if (options.find_systems)
        grow_found_systems(std::move(graph), ct, options, job, result);
    else
        result.tree = directed(graph, wishes_of(options, graph));
    BridgedPoints bridged;
    for (const Bridge& bridge : result.bridges)
        if (bridge.built) bridged.add(bridge.path_mm);
    bridged.mark(result.tree);
    job.advance(1.0);
    return result;
}

VesselTree extract_tree(const Mask& skeleton, const Mask& vessels, const Volume* ct,
                        const TreeOptions& options, Job& job) {
    return extract_tree_and_bridges(skeleton, vessels, ct, options, job).tree;
}

}  // namespace hepatica
