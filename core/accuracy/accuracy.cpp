// SPDX-License-Identifier: GPL-3.0-or-later
// Implements compare(): Dice, clDice, centreline distances, radius errors and greedy matching of
// bifurcations.
#include "core/accuracy/accuracy.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "core/accuracy/mask_on_grid.h"
#include "core/base/error.h"
#include "core/base/median.h"
#include "core/skeleton/thinning.h"
#include "core/skeleton/unit_width_skeleton.h"
#include "core/tree/extraction/centreline.h"
#include "core/tree/extraction/centreline_locator.h"
#include "core/tree/extraction/vessel_graph.h"

namespace hepatica {

namespace {

// A share of nothing is 1.
double share(double part, double whole) {
    return whole > 0.0 ? part / whole : 1.0;
}

// Share of one mask's skeleton that lies inside the other; 0 for an empty skeleton.
double skeleton_share(const Mask& mask, const Mask& other, Job& job) {
    const Mask skeleton = unit_width(thin(mask, ThinningMethod::queue, job), job);
    double inside = 0.0, all = 0.0;
    for (std::size_t i = 0; i < skeleton.voxels.size(); ++i) {
        if (skeleton.voxels[i] == 0) continue;
        const auto [x, y, z] = skeleton.grid.index_of(i);
        inside += value_at(other, skeleton.grid.to_mm(x, y, z)) != 0;
        all += 1.0;
    }
    return all > 0.0 ? inside / all : 0.0;
}

void judge_centrelines(const VesselTree& tree, const VesselTree& truth, Accuracy& accuracy) {
    const CentrelineLocator locator(truth);
    std::vector<double> distances, errors;
    for (const VesselSegment& segment : tree.segments) {
        const Centreline even =
            resampled({segment.points_mm, segment.radii_mm}, 0.5 * accuracy.voxel_mm);
        for (std::size_t i = 0; i < even.points_mm.size(); ++i) {
            const auto nearest =
                locator.nearest(even.points_mm[i], std::numeric_limits<double>::max());
            distances.push_back(nearest->distance_mm);
            if (nearest->distance_mm <= std::max(nearest->radius_mm, accuracy.voxel_mm))
                errors.push_back(even.radii_mm[i] - nearest->radius_mm);
        }
    }
    if (distances.empty()) {
        accuracy.centreline_mean_mm = accuracy.centreline_p95_mm =
            std::numeric_limits<double>::quiet_NaN();
        return;
    }
    for (const double d : distances)
        accuracy.centreline_mean_mm += d / static_cast<double>(distances.size());
    std::ranges::sort(distances);
    accuracy.centreline_median_mm = distances[distances.size() / 2];
    accuracy.centreline_p95_mm = distances[distances.size() * 95 / 100];
    if (errors.empty()) return;
    double sum = 0.0, sum_of_magnitudes = 0.0;
    for (const double e : errors) {
        sum += e;
        sum_of_magnitudes += std::abs(e);
    }
    accuracy.radius_bias_mm = sum / static_cast<double>(errors.size());
    accuracy.radius_mae_mm = sum_of_magnitudes / static_cast<double>(errors.size());
}

double length_found(const VesselTree& tree, const VesselTree& truth, double voxel_mm,
                    const AccuracyOptions& options) {
    const CentrelineLocator locator(tree);
    double found = 0.0, all = 0.0;
    for (const VesselSegment& segment : truth.segments) {
        const Centreline even = resampled({segment.points_mm, segment.radii_mm}, 0.5 * voxel_mm);
        for (std::size_t i = 0; i < even.points_mm.size(); ++i) {
            if (even.radii_mm[i] < options.length_radius_mm) continue;
            // A point stands for half of each edge beside it.
            double weight = 0.0;
            if (i > 0) weight += (even.points_mm[i] - even.points_mm[i - 1]).norm() / 2.0;
            if (i + 1 < even.points_mm.size())
                weight += (even.points_mm[i + 1] - even.points_mm[i]).norm() / 2.0;
            all += weight;
            if (locator.nearest(even.points_mm[i], options.length_tolerance_mm)) found += weight;
        }
    }
    return share(found, all);
}

std::optional<double> median_distance_mm(const VesselTree& from, const VesselTree& to,
                                         double voxel_mm) {
    if (to.segments.empty()) return std::nullopt;
    const CentrelineLocator locator(to);
    std::vector<double> distances;
    for (const VesselSegment& segment : from.segments)
        for (const Vec3& point :
             resampled({segment.points_mm, segment.radii_mm}, 0.5 * voxel_mm).points_mm)
            distances.push_back(
                locator.nearest(point, std::numeric_limits<double>::max())->distance_mm);
    return median(std::move(distances));
}

struct Bifurcation {
    Vec3 position_mm;
    double radius_mm;            // of the widest branch
    double narrowest_radius_mm;  // of the narrowest branch, a little way from the node
};

std::vector<Bifurcation> bifurcations(const VesselTree& tree) {
    const std::vector<int> degrees = node_degrees(tree);
    std::vector<Bifurcation> at_node(tree.nodes.size());
    for (std::size_t n = 0; n < at_node.size(); ++n)
        at_node[n] = {tree.nodes[n].position_mm, 0.0, std::numeric_limits<double>::infinity()};
    for (const VesselSegment& segment : tree.segments) {
        // Taken at the middle of the branch: at the node the radius is that of the parent.
        const double radius = segment.radii_mm[segment.radii_mm.size() / 2];
        for (const int node : {segment.proximal_node, segment.distal_node}) {
            at_node[node].radius_mm = std::max(at_node[node].radius_mm, radius);
            at_node[node].narrowest_radius_mm = std::min(at_node[node].narrowest_radius_mm, radius);
        }
    }
    std::vector<Bifurcation> found;
    for (std::size_t n = 0; n < at_node.size(); ++n)
        for (int i = 2; i < degrees[n]; ++i) found.push_back(at_node[n]);
    return found;
}

std::vector<Bifurcation> wide_ones(std::vector<Bifurcation> all, double radius_mm) {
    std::erase_if(all, [&](const Bifurcation& b) { return b.narrowest_radius_mm < radius_mm; });
    return all;
}

// Number of `asked` that have a partner of their own in `given`: greedy, the nearest pairs first.
int matched(const std::vector<Bifurcation>& asked, const std::vector<Bifurcation>& given,
            double voxel_mm, bool asked_is_truth) {
    std::vector<std::tuple<double, std::size_t, std::size_t>> pairs;
    for (std::size_t i = 0; i < asked.size(); ++i)
        for (std::size_t j = 0; j < given.size(); ++j) {
            const double true_radius = asked_is_truth ? asked[i].radius_mm : given[j].radius_mm;
            const double distance = (asked[i].position_mm - given[j].position_mm).norm();
            if (distance <= std::max(3.0 * voxel_mm, true_radius))
                pairs.emplace_back(distance, i, j);
        }
    std::ranges::sort(pairs);
    std::vector<std::uint8_t> asked_done(asked.size(), 0), given_done(given.size(), 0);
    int count = 0;
    for (const auto& [distance, i, j] : pairs) {
        if (asked_done[i] != 0 || given_done[j] != 0) continue;
        asked_done[i] = given_done[j] = 1;
        ++count;
    }
    return count;
}

void judge_bifurcations(const VesselTree& tree, const VesselTree& truth,
                        const AccuracyOptions& options, Accuracy& accuracy) {
    const double radius_mm = options.bifurcation_radius_mm < 0.0 ? 1.5 * accuracy.voxel_mm
                                                                 : options.bifurcation_radius_mm;
    const std::vector<Bifurcation> ours = bifurcations(tree), theirs = bifurcations(truth);
    const std::vector<Bifurcation> our_wide = wide_ones(ours, radius_mm);
    const std::vector<Bifurcation> their_wide = wide_ones(theirs, radius_mm);
    accuracy.tree_bifurcations = static_cast<int>(our_wide.size());
    accuracy.truth_bifurcations = static_cast<int>(their_wide.size());
    accuracy.bifurcation_recall =
        share(matched(their_wide, ours, accuracy.voxel_mm, true), accuracy.truth_bifurcations);
    if (tree.segments.empty()) return;  // nothing is found, so the precision stays 0
    accuracy.bifurcation_precision =
        share(matched(our_wide, theirs, accuracy.voxel_mm, false), accuracy.tree_bifurcations);
}

int component_count(const VesselTree& tree) {
    const std::vector<int> component = component_of_nodes(to_graph(tree));
    return component.empty() ? 0 : *std::ranges::max_element(component) + 1;
}

}  // namespace

double dice_of(const Mask& mask, const Mask& truth, Job& job) {
    const Mask judged = mask_on_grid(mask, truth.grid, job);
    double both = 0.0, sum = 0.0;
    for (std::size_t i = 0; i < truth.voxels.size(); ++i) {
        both += truth.voxels[i] && judged.voxels[i];
        sum += (truth.voxels[i] != 0) + (judged.voxels[i] != 0);
    }
    return share(2.0 * both, sum);
}

Accuracy compare(const VesselTree& tree, const Mask& mask, const VesselTree& truth_tree,
                 const Mask& truth_mask, const AccuracyOptions& options, Job& job) {
    if (truth_tree.segments.empty())
        throw InputError("the true tree has no segments", "", "Give the tree that is the truth");
    if (std::ranges::all_of(truth_mask.voxels, [](auto v) { return v == 0; }))
        throw InputError("the true mask is empty", "", "Give the mask that is the truth");
    if (mask.voxels.empty())
        throw InputError("there is no mask to judge", "",
                         "Give a case that was reconstructed from a CT, with its voxels");
    Accuracy accuracy;
    accuracy.voxel_mm = std::cbrt(truth_mask.grid.spacing_mm.prod());
    accuracy.dice = dice_of(mask, truth_mask, job);
    job.advance(0.3);
    const double precision = skeleton_share(mask, truth_mask, job);
    const double sensitivity = skeleton_share(truth_mask, mask, job);
    accuracy.cldice = precision + sensitivity > 0.0
                          ? 2.0 * precision * sensitivity / (precision + sensitivity)
                          : 0.0;
    job.advance(0.7);
    judge_centrelines(tree, truth_tree, accuracy);
    accuracy.truth_median_mm = median_distance_mm(truth_tree, tree, accuracy.voxel_mm);
    accuracy.length_found = length_found(tree, truth_tree, accuracy.voxel_mm, options);
    judge_bifurcations(tree, truth_tree, options, accuracy);
    accuracy.components = component_count(tree);
    accuracy.truth_components = component_count(truth_tree);
    job.advance(1.0);
    return accuracy;
}

}  // namespace hepatica
