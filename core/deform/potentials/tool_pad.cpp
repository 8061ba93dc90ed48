// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/potentials/tool_pad.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/base/small_matrix_eigen.h"
#include "core/deform/potentials/thin_pads.h"

namespace hepatica {
namespace {

constexpr double most_stretch = 1.5;  // of the surface, up to which that holds
constexpr int most_cuts = 32;         // per edge of a triangle

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

// Cuts the triangle into n^2 equal ones, each of which gives a third of its area to each corner. In
// a triangle with edges s no point is farther than s / sqrt(3) from a corner, and a sphere of
// radius R bulges there by s^2 / (6 R).
void ToolPad::add_points_of(int triangle, const Tool& tool, double radius_mm, int part,
                            std::vector<PadPoint>& points) const {
    const double pad = pad_of_triangle_mm(tool, surface_.triangles()[triangle]);
    const double edge = longest_edge_mm_[triangle];
    const double apart = std::sqrt(6.0 * dip_of_pad * pad * radius_mm) / most_stretch;
    const int n = std::clamp(static_cast<int>(std::ceil(edge / apart)), 1, most_cuts);
    const double dip =
        std::min(dip_of_pad * pad, std::pow(most_stretch * edge / n, 2) / (6.0 * radius_mm));
    const auto& [a, b, c] = surface_.triangles()[triangle];
    for (int i = 0; i <= n; ++i)
        for (int j = 0; i + j <= n; ++j) {
            const double v = static_cast<double>(i) / n, w = static_cast<double>(j) / n;
            const int on_borders = (i == 0) + (j == 0) + (i + j == n);
            const double share = on_borders == 0 ? 6.0 : (on_borders == 1 ? 3.0 : 1.0);
            const double strength = share / (3.0 * n * n) * area_mm2_[triangle] * tool.pressure_pa;
            points.push_back(
                {{a, b, c}, {static_cast<double>(n - i - j) / n, v, w}, part, pad, strength, dip});
        }
}

void ToolPad::add_contacts_of(int triangle, const Tool& tool, const Capsule& shape, int part,
                              std::span<const Vec3> positions_mm, std::vector<PadPoint>& points,
                              std::vector<PadContact>& found) const {
    points.clear();
    add_points_of(triangle, tool, shape.radius_mm, part, points);
    const PadCapsule capsule = pad_capsule(shape);
    small::Vector3<double> corners[3];
    for (int a = 0; a < 3; ++a)
        corners[a] = small::from_eigen(positions_mm[surface_.triangles()[triangle][a]]);
    for (const PadPoint& point : points) {
        const PointPull pull = pull_of(point, capsule, corners);
        if (!pull.pressed) continue;
        found.push_back({part,
                         pull.along,
                         triangle,
                         {point.weights[0], point.weights[1], point.weights[2]},
                         small::to_eigen(pull.normal),
                         small::to_eigen(pull.at),
                         pull.pad.force_un,
                         pull.pad.stiffness_un_per_mm,
                         pull.pad.energy_nj});
    }
}

PadCapsule pad_capsule(const Capsule& shape) {
    const Segment axis = shape.axis();
    return {small::from_eigen(axis[0]), small::from_eigen(axis[1]), shape.radius_mm};
}

std::vector<std::vector<int>> ToolPad::triangles_near(const Tool& tool,
                                                      std::span<const Capsule> shapes,
                                                      std::span<const Vec3> positions_mm) const {
    std::vector<Box> boxes(shapes.size());
    for (std::size_t p = 0; p < shapes.size(); ++p) {
        for (const Vec3& end : shapes[p].axis()) boxes[p].add(end);
        boxes[p].grow(shapes[p].radius_mm + (1.0 + dip_of_pad) * tool.pad_mm);
    }
    return surface_.triangles_in(boxes, positions_mm);
}

std::vector<PadContact> ToolPad::contacts(const Tool& tool, std::span<const Capsule> shapes,
                                          std::span<const Vec3> positions_mm) const {
    const std::vector<std::vector<int>> near = triangles_near(tool, shapes, positions_mm);
    std::vector<PadContact> found;
    std::vector<PadPoint> points;
    for (std::size_t p = 0; p < shapes.size(); ++p)
        for (const int t : near[p])
            add_contacts_of(t, tool, shapes[p], static_cast<int>(p), positions_mm, points, found);
    return found;
}

std::vector<PadPoint> ToolPad::points_near(const Tool& tool, std::span<const Capsule> shapes,
                                           std::span<const Vec3> positions_mm,
                                           std::span<const Vec3> other_positions_mm) const {
    const auto near = triangles_near(tool, shapes, positions_mm);
    const auto other = triangles_near(tool, shapes, other_positions_mm);
    std::vector<PadPoint> points;
    for (std::size_t p = 0; p < shapes.size(); ++p) {
        std::vector<int> triangles;
        std::ranges::set_union(near[p], other[p], std::back_inserter(triangles));
        for (const int t : triangles)
            add_points_of(t, tool, shapes[p].radius_mm, static_cast<int>(p), points);
    }
    return points;
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
