// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/solvers/coarse_skeleton.h"
#include "core/base/number_text.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "core/base/error.h"
#include "core/base/parallel.h"

namespace hepatica {

namespace {

[[noreturn]] void reject(const std::string& problem, const std::string& place) {
    throw InputError(problem, place,
                     "Extract the centreline again, or leave it out: the solver "
                     "then makes one from the mesh.");
}

void check_point(const Vec3& position_mm, double radius_mm, const std::string& place) {
    if (!position_mm.allFinite()) reject("a position is not finite", place);
    if (!(radius_mm > 0.0) || !std::isfinite(radius_mm)) {
        reject("the radius is " + number_text(radius_mm) + " mm", place);
    }
}

// Arc length of a polyline up to each of its points, in units of the node spacing.
std::vector<double> spacings_along(const SkeletonPolyline& line, double spacing_diameters) {
    std::vector<double> along{0.0};
    for (std::size_t k = 1; k < line.points_mm.size(); ++k) {
        const double diameter = line.radii_mm[k - 1] + line.radii_mm[k];
        const double length = (line.points_mm[k] - line.points_mm[k - 1]).norm();
        along.push_back(along.back() + length / (spacing_diameters * diameter));
    }
    return along;
}

struct Edge {
    int parent = -1;
    int child = -1;
};

// A run of consecutive edges and its bounding box, by which most edges are skipped.
struct EdgeGroup {
    std::size_t begin = 0;
    std::size_t end = 0;
    Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity());
    Vec3 high = Vec3::Constant(-std::numeric_limits<double>::infinity());
    double largest_radius = 0.0;
};

std::vector<EdgeGroup> group_edges(const CoarseSkeleton& skeleton, const std::vector<Edge>& edges) {
    constexpr std::size_t edges_per_group = 16;
    std::vector<EdgeGroup> groups;
    for (std::size_t begin = 0; begin < edges.size(); begin += edges_per_group) {
        EdgeGroup group;
        group.begin = begin;
        group.end = std::min(begin + edges_per_group, edges.size());
        for (std::size_t e = group.begin; e < group.end; ++e) {
            for (const int node : {edges[e].parent, edges[e].child}) {
                group.low = group.low.cwiseMin(skeleton.positions_mm[node]);
                group.high = group.high.cwiseMax(skeleton.positions_mm[node]);
                group.largest_radius = std::max(group.largest_radius, skeleton.radii_mm[node]);
            }
        }
        groups.push_back(group);
    }
    return groups;
}

// Squared distance to an edge in local radii, and the position of the nearest point along it.
struct Nearest {
    double distance_squared = std::numeric_limits<double>::infinity();
    Edge edge;
    double fraction = 0.0;
};

Nearest nearest_on(const CoarseSkeleton& skeleton, const Edge& edge, const Vec3& point) {
    const Vec3& start = skeleton.positions_mm[edge.parent];
    const Vec3 along = skeleton.positions_mm[edge.child] - start;
    const double length_squared = along.squaredNorm();
    Nearest nearest;
    nearest.edge = edge;
    if (length_squared > 0.0) {
        nearest.fraction = std::clamp((point - start).dot(along) / length_squared, 0.0, 1.0);
    }
    const double radius = (1.0 - nearest.fraction) * skeleton.radii_mm[edge.parent] +
                          nearest.fraction * skeleton.radii_mm[edge.child];
    nearest.distance_squared =
        (start + nearest.fraction * along - point).squaredNorm() / (radius * radius);
    return nearest;
}

}  // namespace

CoarseSkeleton resample(std::span<const SkeletonPolyline> polylines, double spacing_diameters) {
    CoarseSkeleton skeleton;
    std::vector<int> last_node;  // of each polyline
    for (std::size_t p = 0; p < polylines.size(); ++p) {
        const SkeletonPolyline& line = polylines[p];
        const std::string place = "centreline " + std::to_string(p);
        if (line.points_mm.empty() || line.points_mm.size() != line.radii_mm.size()) {
            reject("points and radii do not match", place);
        }
        if (line.parent >= static_cast<int>(p)) reject("its parent comes later", place);
        for (std::size_t k = 0; k < line.points_mm.size(); ++k) {
            check_point(line.points_mm[k], line.radii_mm[k], place);
        }
        const auto add = [&](const Vec3& position, double radius, int parent) {
            skeleton.positions_mm.push_back(position);
            skeleton.radii_mm.push_back(radius);
            skeleton.parent.push_back(parent);
            return skeleton.size() - 1;
        };
        int node =
            line.parent < 0 ? add(line.points_mm[0], line.radii_mm[0], -1) : last_node[line.parent];
        const std::vector<double> along = spacings_along(line, spacing_diameters);
        const int intervals =
            along.back() < 1.0 / 3.0 ? 0 : std::max(1, static_cast<int>(std::lround(along.back())));
        std::size_t k = 1;
        for (int n = 1; n <= intervals; ++n) {
            const double target = along.back() * n / intervals;
            while (k + 1 < along.size() && along[k] < target) ++k;
            const double step = along[k] - along[k - 1];
            const double t = step > 0.0 ? std::min((target - along[k - 1]) / step, 1.0) : 1.0;
            node = add((1.0 - t) * line.points_mm[k - 1] + t * line.points_mm[k],
                       (1.0 - t) * line.radii_mm[k - 1] + t * line.radii_mm[k], node);
        }
        last_node.push_back(node);
    }
    return skeleton;
}

void validate(const CoarseSkeleton& skeleton) {
    const std::size_t count = skeleton.positions_mm.size();
    if (skeleton.parent.size() != count || skeleton.radii_mm.size() != count) {
        reject("positions, parents and radii differ in number", "skeleton");
    }
    for (std::size_t n = 0; n < count; ++n) {
        const std::string place = "skeleton node " + std::to_string(n);
        check_point(skeleton.positions_mm[n], skeleton.radii_mm[n], place);
        const int parent = skeleton.parent[n];
        if (parent < -1 || parent >= static_cast<int>(n)) {
            reject("its parent is " + std::to_string(parent), place);
        }
    }
}

SkeletonBinding bind_vertices(const CoarseSkeleton& skeleton, std::span<const Vec3> positions_mm) {
    std::vector<Edge> edges;
    std::vector<char> has_child(skeleton.parent.size(), 0);
    for (int n = 0; n < skeleton.size(); ++n) {
        if (skeleton.parent[n] < 0) continue;
        edges.push_back({skeleton.parent[n], n});
        has_child[skeleton.parent[n]] = 1;
    }
    for (int n = 0; n < skeleton.size(); ++n) {
        if (skeleton.parent[n] < 0 && !has_child[n]) edges.push_back({n, n});
    }
    const std::vector<EdgeGroup> groups = group_edges(skeleton, edges);

    SkeletonBinding binding;
    binding.nodes.resize(positions_mm.size());
    binding.weights.resize(positions_mm.size());
    parallel_blocks(positions_mm.size(), 512, [&](std::size_t begin, std::size_t end) {
        for (std::size_t v = begin; v < end; ++v) {
            const Vec3& point = positions_mm[v];
            Nearest best;
            for (const EdgeGroup& group : groups) {
                const Vec3 outside = (group.low - point).cwiseMax(point - group.high).cwiseMax(0.0);
                const double reach = group.largest_radius * group.largest_radius;
                if (outside.squaredNorm() > reach * best.distance_squared) continue;
                for (std::size_t e = group.begin; e < group.end; ++e) {
                    const Nearest found = nearest_on(skeleton, edges[e], point);
                    if (found.distance_squared < best.distance_squared) best = found;
                }
            }
            const bool one = best.edge.parent == best.edge.child;
            binding.nodes[v] = {best.edge.parent, best.edge.child};
            binding.weights[v] = {one ? 1.0 : 1.0 - best.fraction, one ? 0.0 : best.fraction};
        }
    });
    return binding;
}

}  // namespace hepatica
