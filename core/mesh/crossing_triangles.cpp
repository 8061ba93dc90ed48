// SPDX-License-Identifier: GPL-3.0-or-later
// Sweep along x over bounding boxes, then CGAL's exact intersection predicates.
#include "core/mesh/crossing_triangles.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/intersections.h>

#include <algorithm>
#include <numeric>

namespace hepatica {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

Kernel::Point_3 point(const Vec3& x) {
    return {x.x(), x.y(), x.z()};
}

Kernel::Triangle_3 triangle(const std::array<int, 3>& corners, std::span<const Vec3> x) {
    return {point(x[corners[0]]), point(x[corners[1]]), point(x[corners[2]])};
}

// The corners of `a` that are not corners of `b`.
std::vector<int> beside(const std::array<int, 3>& a, const std::array<int, 3>& b) {
    std::vector<int> corners;
    for (const int v : a)
        if (std::ranges::find(b, v) == b.end()) corners.push_back(v);
    return corners;
}

// Two triangles with one common corner share another point only if the edge opposite that corner,
// of one of them, meets the other triangle.
bool edge_meets(const std::vector<int>& edge, const std::array<int, 3>& other,
                std::span<const Vec3> x) {
    return CGAL::do_intersect(Kernel::Segment_3(point(x[edge[0]]), point(x[edge[1]])),
                              triangle(other, x));
}

bool cross(const std::array<int, 3>& a, const std::array<int, 3>& b, std::span<const Vec3> x) {
    const std::vector<int> of_a = beside(a, b), of_b = beside(b, a);
    if (of_a.size() < 2) return false;
    if (triangle(a, x).is_degenerate() || triangle(b, x).is_degenerate()) return false;
    if (of_a.size() == 2) return edge_meets(of_a, b, x) || edge_meets(of_b, a, x);
    return CGAL::do_intersect(triangle(a, x), triangle(b, x));
}

struct Extent {
    Vec3 low, high;
};

}  // namespace

std::vector<std::array<int, 2>> crossing_triangles(std::span<const std::array<int, 3>> triangles,
                                                   std::span<const Vec3> positions_mm) {
    std::vector<Extent> extents;
    for (const auto& t : triangles) {
        const Vec3 &a = positions_mm[t[0]], &b = positions_mm[t[1]], &c = positions_mm[t[2]];
        extents.push_back({a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c)});
    }
    std::vector<int> along_x(triangles.size());
    std::iota(along_x.begin(), along_x.end(), 0);
    std::ranges::sort(along_x, {}, [&](int t) { return extents[t].low.x(); });
    std::vector<std::array<int, 2>> found;
    for (std::size_t i = 0; i < along_x.size(); ++i) {
        const Extent& first = extents[along_x[i]];
        for (std::size_t j = i + 1; j < along_x.size(); ++j) {
            const Extent& second = extents[along_x[j]];
            if (second.low.x() > first.high.x()) break;
            if ((second.low.array() > first.high.array()).any() ||
                (first.low.array() > second.high.array()).any())
                continue;
            const int a = std::min(along_x[i], along_x[j]), b = std::max(along_x[i], along_x[j]);
            if (cross(triangles[a], triangles[b], positions_mm)) found.push_back({a, b});
        }
    }
    std::ranges::sort(found);
    return found;
}

}  // namespace hepatica
