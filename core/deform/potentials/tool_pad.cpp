// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/potentials/tool_pad.h"

#include <algorithm>
#include <cmath>

#include "core/deform/potentials/pad_barrier.h"

namespace hepatica {
namespace {

constexpr double dip_of_pad = 0.125;  // how far a triangle may bulge into the pad between points
constexpr double most_stretch = 1.5;  // of the surface, for which that holds
constexpr int most_cuts = 32;         // of a triangle's edge

}  // namespace

ToolPad::ToolPad(SurfacePatches surface, std::span<const Vec3> rest_mm)
    : surface_(std::move(surface)) {
    for (const auto& triangle : surface_.triangles()) {
        const Triangle x = corners_of(triangle, rest_mm);
        area_mm2_.push_back(0.5 * (x[1] - x[0]).cross(x[2] - x[0]).norm());
        longest_edge_mm_.push_back(
            std::max({(x[1] - x[0]).norm(), (x[2] - x[1]).norm(), (x[0] - x[2]).norm()}));
    }
}

// The corners of n^2 equal triangles into which it is cut; each of those gives a third of its area
// to each of its corners. A point of a triangle of edges s is at most s / sqrt(3) from a corner,
// and the ball bulges there by s^2 / (6 R).
void ToolPad::add_points_of(int triangle, const Tool& tool, const Capsule& shape, int part,
                            std::span<const Vec3> positions_mm,
                            std::vector<PadContact>& found) const {
    const double pad = tool.pad_mm, edge = longest_edge_mm_[triangle];
    const double apart = std::sqrt(6.0 * dip_of_pad * pad * shape.radius_mm) / most_stretch;
    const int n = std::clamp(static_cast<int>(std::ceil(edge / apart)), 1, most_cuts);
    const double dip =
        std::min(dip_of_pad * pad, std::pow(most_stretch * edge / n, 2) / (6.0 * shape.radius_mm));
    const Triangle corners = corners_of(surface_.triangles()[triangle], positions_mm);
    const Segment axis = shape.axis();
    for (int i = 0; i <= n; ++i)
        for (int j = 0; i + j <= n; ++j) {
            const double v = static_cast<double>(i) / n, w = static_cast<double>(j) / n;
            const std::array<double, 3> weights{static_cast<double>(n - i - j) / n, v, w};
            const Vec3 point = point_at(corners, weights);
            const PointSegment on = closest(point, axis);
            const double distance = std::sqrt(on.squared_mm2);
            const double gap = distance - shape.radius_mm - dip;
            if (!(gap < pad)) continue;
            const int on_borders = (i == 0) + (j == 0) + (i + j == n);
            const double share = on_borders == 0 ? 6.0 : (on_borders == 1 ? 3.0 : 1.0);
            const double strength = share / (3.0 * n * n) * area_mm2_[triangle] * tool.pressure_pa;
            const PadBarrier barrier = pad_barrier(gap, pad, strength);
            const Vec3 normal = (point - point_at(axis, on.along)) / distance;
            found.push_back({part, on.along, triangle, weights, normal, point, barrier.force_un,
                             barrier.stiffness_un_per_mm, barrier.energy_nj});
        }
}

std::vector<PadContact> ToolPad::contacts(const Tool& tool, std::span<const Capsule> shapes,
                                          std::span<const Vec3> positions_mm) const {
    std::vector<Box> boxes(shapes.size());
    for (std::size_t p = 0; p < shapes.size(); ++p) {
        for (const Vec3& end : shapes[p].axis()) boxes[p].add(end);
        boxes[p].grow(shapes[p].radius_mm + (1.0 + dip_of_pad) * tool.pad_mm);
    }
    const std::vector<std::vector<int>> near = surface_.triangles_in(boxes, positions_mm);
    std::vector<PadContact> found;
    for (std::size_t p = 0; p < shapes.size(); ++p)
        for (const int t : near[p])
            add_points_of(t, tool, shapes[p], static_cast<int>(p), positions_mm, found);
    return found;
}

double ToolPad::least_gap_mm(const Tool& tool, std::span<const Vec3> positions_mm) const {
    double least = std::numeric_limits<double>::max();
    for (const ToolPart& part : tool.parts)
        for (const NearTriangle& near :
             near_capsule(part.shape, surface_, positions_mm, (1.0 + dip_of_pad) * tool.pad_mm))
            least = std::min(least, near.gap_mm);
    return least;
}

}  // namespace hepatica
