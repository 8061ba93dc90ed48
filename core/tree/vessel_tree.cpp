// SPDX-License-Identifier: GPL-3.0-or-later
// Measures and checks vessel trees.
#include "core/tree/vessel_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "core/base/error.h"
#include "core/tree/station.h"

namespace hepatica {

double length_mm(const VesselSegment& segment) {
    double length = 0.0;
    for (std::size_t i = 1; i < segment.points_mm.size(); ++i)
        length += (segment.points_mm[i] - segment.points_mm[i - 1]).norm();
    return length;
}

double length_mm(const VesselTree& tree) {
    double length = 0.0;
    for (const VesselSegment& segment : tree.segments) length += length_mm(segment);
    return length;
}

double bridged_length_mm(const VesselTree& tree) {
    double length = 0.0;
    for (const VesselSegment& segment : tree.segments)
        for (std::size_t i = 1; i < segment.bridged.size(); ++i)
            if (segment.bridged[i] != 0 || segment.bridged[i - 1] != 0)
                length += (segment.points_mm[i] - segment.points_mm[i - 1]).norm();
    return length;
}

std::vector<int> roots(const VesselTree& tree) {
    std::vector<int> ids;
    for (std::size_t i = 0; i < tree.segments.size(); ++i)
        if (tree.segments[i].parent < 0 && !tree.segments[i].closes_loop)
            ids.push_back(static_cast<int>(i));
    return ids;
}

std::vector<std::vector<int>> children(const VesselTree& tree) {
    std::vector<std::vector<int>> ids(tree.segments.size());
    for (std::size_t i = 0; i < tree.segments.size(); ++i)
        if (tree.segments[i].parent >= 0)
            ids[tree.segments[i].parent].push_back(static_cast<int>(i));
    return ids;
}

std::vector<std::uint8_t> downstream_of(const VesselTree& tree, int segment) {
    std::vector<std::uint8_t> hangs(tree.segments.size(), 0);
    hangs[segment] = 1;
    for (std::size_t i = segment + 1; i < tree.segments.size(); ++i)
        if (tree.segments[i].parent >= 0) hangs[i] = hangs[tree.segments[i].parent];
    return hangs;
}

void set_strahler_orders(VesselTree& tree) {
    std::vector<int> highest(tree.segments.size(), 0), how_many(tree.segments.size(), 0);
    for (std::size_t i = tree.segments.size(); i-- > 0;) {
        VesselSegment& segment = tree.segments[i];
        segment.strahler_order = highest[i] == 0 ? 1 : highest[i] + (how_many[i] >= 2 ? 1 : 0);
        const int parent = segment.parent;
        if (parent < 0 || segment.closes_loop) continue;
        if (segment.strahler_order > highest[parent]) {
            highest[parent] = segment.strahler_order;
            how_many[parent] = 0;
        }
        if (segment.strahler_order == highest[parent]) ++how_many[parent];
    }
}

std::vector<int> node_degrees(const VesselTree& tree) {
    std::vector<int> degrees(tree.nodes.size(), 0);
    for (const VesselSegment& segment : tree.segments) {
        ++degrees[segment.proximal_node];
        ++degrees[segment.distal_node];
    }
    return degrees;
}

int bifurcation_count(const VesselTree& tree) {
    const std::vector<int> degrees = node_degrees(tree);
    return static_cast<int>(std::ranges::count_if(degrees, [](int d) { return d >= 3; }));
}

int end_count(const VesselTree& tree) {
    const std::vector<int> degrees = node_degrees(tree);
    return static_cast<int>(std::ranges::count(degrees, 1));
}

TreePoint nearest_point(const VesselTree& tree, const Vec3& position_mm) {
    if (tree.segments.empty())
        throw InputError("the vessel tree has no segments", "", "Reconstruct the patient first");
    TreePoint best;
    best.distance_mm = std::numeric_limits<double>::infinity();
    for (std::size_t s = 0; s < tree.segments.size(); ++s) {
        const NearestStation place = nearest_station(tree.segments[s], position_mm);
        if (place.distance_mm < best.distance_mm)
            best = {static_cast<int>(s), place.arclength_mm, place.distance_mm};
    }
    return best;
}

namespace {

[[noreturn]] void reject(const std::string& what, std::size_t segment) {
    throw InputError(what, "segment " + std::to_string(segment),
                     "The tree file is damaged or not a vessel tree");
}

void validate_points(const VesselSegment& segment, std::size_t id) {
    if (segment.points_mm.size() < 2) reject("has fewer than two points", id);
    if (segment.radii_mm.size() != segment.points_mm.size())
        reject("does not have one radius per point", id);
    if (!segment.bridged.empty() && segment.bridged.size() != segment.points_mm.size())
        reject("does not say of each point whether it bridges a gap", id);
    for (std::size_t i = 0; i < segment.points_mm.size(); ++i) {
        if (!segment.points_mm[i].allFinite()) reject("has a point that is not finite", id);
        if (!(segment.radii_mm[i] > 0.0) || !std::isfinite(segment.radii_mm[i]))
            reject("has a radius that is not positive", id);
        if (i > 0 && segment.points_mm[i] == segment.points_mm[i - 1])
            reject("has two equal consecutive points", id);
    }
}

}  // namespace

void validate(const VesselTree& tree) {
    const int nodes = static_cast<int>(tree.nodes.size());
    for (std::size_t id = 0; id < tree.segments.size(); ++id) {
        const VesselSegment& segment = tree.segments[id];
        if (segment.proximal_node < 0 || segment.proximal_node >= nodes ||
            segment.distal_node < 0 || segment.distal_node >= nodes)
            reject("names a node that does not exist", id);
        if (segment.parent >= static_cast<int>(id)) reject("stands before its parent", id);
        if (segment.parent >= 0 &&
            tree.segments[segment.parent].distal_node != segment.proximal_node)
            reject("does not begin where its parent ends", id);
        if (!(segment.system_confidence >= 0.0 && segment.system_confidence <= 1.0))
            reject("has a confidence outside 0 to 1", id);
        validate_points(segment, id);
    }
}

}  // namespace hepatica
