// SPDX-License-Identifier: GPL-3.0-or-later
// Distances to round cones in closed form, looked up through a regular grid of cells.
#include "core/mesh/tube_field.h"

#include <algorithm>
#include <cmath>

namespace hepatica {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::size_t most_cells = 4'000'000;

// Of length 1; any direction where the points coincide.
Vec3 direction(const Vec3& from, const Vec3& to) {
    const Vec3 way = to - from;
    const double length = way.norm();
    return length > 0.0 ? Vec3(way / length) : Vec3::UnitX();
}

double smooth_minimum(double a, double b, double width) {
    const double overlap = width - std::abs(a - b);
    if (overlap <= 0.0) return std::min(a, b);
    return std::min(a, b) - overlap * overlap / (4.0 * width);
}

}  // namespace

TubeField::TubeField(const VesselTree& tree, const std::vector<int>& segments,
                     const TubeFieldOptions& options)
    : node_blend_mm_(tree.nodes.size(), 0.0) {
    for (const int segment : segments) add_vessel(tree, segment, options);
    for (const Cone& cone : cones_) {
        lower_mm_ = lower_mm_.cwiseMin((cone.a.array() - cone.radius_a).matrix())
                        .cwiseMin((cone.b.array() - cone.radius_b).matrix());
        upper_mm_ = upper_mm_.cwiseMax((cone.a.array() + cone.radius_a).matrix())
                        .cwiseMax((cone.b.array() + cone.radius_b).matrix());
        smallest_radius_mm_ = std::min({smallest_radius_mm_, cone.radius_a, cone.radius_b});
    }
    const double widest_blend = *std::ranges::max_element(node_blend_mm_);
    reach_mm_ = std::max(widest_blend, 0.25 * smallest_radius_mm_);
    build_grid();
}

void TubeField::add_vessel(const VesselTree& tree, int segment, const TubeFieldOptions& options) {
    const VesselSegment& vessel = tree.segments[segment];
    const auto radius = [&](std::size_t i) {
        return options.radius_factor * std::max(vessel.radii_mm[i], options.minimum_radius_mm);
    };
    const int id = static_cast<int>(vessels_.size());
    vessels_.push_back({vessel.proximal_node, vessel.distal_node});
    const std::size_t last = vessel.points_mm.size() - 1;
    // Centreline points closer than half a radius add work but no shape.
    for (std::size_t from = 0; from < last;) {
        std::size_t to = from + 1;
        while (to < last &&
               (vessel.points_mm[to] - vessel.points_mm[from]).norm() < 0.5 * radius(from))
            ++to;
        cones_.push_back(
            {vessel.points_mm[from], vessel.points_mm[to], radius(from), radius(to), id});
        from = to;
    }
    for (const auto& [node, end] :
         {std::pair{vessel.proximal_node, std::size_t{0}}, std::pair{vessel.distal_node, last}}) {
        const double width = options.blend_in_radii * radius(end);
        double& blend = node_blend_mm_[node];
        blend = blend == 0.0 ? width : std::min(blend, width);
    }
}

double TubeField::distance_to(const Cone& cone, const Vec3& point_mm) {
    const Vec3 axis = cone.b - cone.a;
    const Vec3 from_a = point_mm - cone.a;
    const double length = axis.norm();
    const double shrink = cone.radius_a - cone.radius_b;
    if (std::abs(shrink) >= length)  // one ball contains the other
        return std::min(from_a.norm() - cone.radius_a, (point_mm - cone.b).norm() - cone.radius_b);
    // In the half plane through the axis, in coordinates along the generatrix that touches both
    // balls.
    const double along = from_a.dot(axis) / length;
    const double across = std::sqrt(std::max(0.0, from_a.squaredNorm() - along * along));
    const double sine = shrink / length;
    const double cosine = std::sqrt(1.0 - sine * sine);
    const double on_side = along * cosine - across * sine;
    if (on_side <= 0.0) return from_a.norm() - cone.radius_a;
    if (on_side >= length * cosine) return (point_mm - cone.b).norm() - cone.radius_b;
    return across * cosine + along * sine - cone.radius_a;
}

template <class Visit>
void TubeField::for_each_cell(const Cone& cone, const Visit& visit) const {
    const double reach = std::max(cone.radius_a, cone.radius_b) + reach_mm_;
    const Vec3 low = (cone.a.cwiseMin(cone.b).array() - reach).matrix();
    const Vec3 high = (cone.a.cwiseMax(cone.b).array() + reach).matrix();
    Index3 first{}, last{};
    for (int axis = 0; axis < 3; ++axis) {
        const double begin = (low[axis] - lower_mm_[axis]) / cell_mm_;
        const double end = (high[axis] - lower_mm_[axis]) / cell_mm_;
        first[axis] = std::clamp(static_cast<int>(begin), 0, grid_dims_[axis] - 1);
        last[axis] = std::clamp(static_cast<int>(end), 0, grid_dims_[axis] - 1);
    }
    const double half_diagonal = 0.5 * std::sqrt(3.0) * cell_mm_;
    for (int z = first[2]; z <= last[2]; ++z)
        for (int y = first[1]; y <= last[1]; ++y)
            for (int x = first[0]; x <= last[0]; ++x) {
                const Vec3 centre = lower_mm_ + cell_mm_ * Vec3(x + 0.5, y + 0.5, z + 0.5);
                if (distance_to(cone, centre) > reach_mm_ + half_diagonal) continue;
                visit(static_cast<std::size_t>(x) +
                      static_cast<std::size_t>(grid_dims_[0]) *
                          (static_cast<std::size_t>(y) +
                           static_cast<std::size_t>(grid_dims_[1]) * static_cast<std::size_t>(z)));
            }
}

void TubeField::build_grid() {
    lower_mm_.array() -= reach_mm_;
    upper_mm_.array() += reach_mm_;
    const Vec3 size = upper_mm_ - lower_mm_;
    cell_mm_ =
        std::max(smallest_radius_mm_, std::cbrt(size.prod() / static_cast<double>(most_cells)));
    for (int axis = 0; axis < 3; ++axis)
        grid_dims_[axis] = static_cast<int>(size[axis] / cell_mm_) + 1;
    const std::size_t cells = static_cast<std::size_t>(grid_dims_[0]) *
                              static_cast<std::size_t>(grid_dims_[1]) *
                              static_cast<std::size_t>(grid_dims_[2]);
    cell_begin_.assign(cells + 1, 0);
    for (const Cone& cone : cones_)
        for_each_cell(cone, [&](std::size_t cell) { ++cell_begin_[cell + 1]; });
    for (std::size_t cell = 0; cell < cells; ++cell) cell_begin_[cell + 1] += cell_begin_[cell];
    cell_cones_.resize(static_cast<std::size_t>(cell_begin_.back()));
    std::vector<int> next(cell_begin_.begin(), cell_begin_.end() - 1);
    for (std::size_t i = 0; i < cones_.size(); ++i)
        for_each_cell(cones_[i], [&](std::size_t cell) {
            cell_cones_[static_cast<std::size_t>(next[cell]++)] = static_cast<int>(i);
        });
}

std::span<const int> TubeField::cones_near(const Vec3& point_mm) const {
    std::size_t cell = 0;
    for (int axis = 2; axis >= 0; --axis) {
        const double position = (point_mm[axis] - lower_mm_[axis]) / cell_mm_;
        if (!(position >= 0.0 && position < grid_dims_[axis])) return {};
        cell =
            cell * static_cast<std::size_t>(grid_dims_[axis]) + static_cast<std::size_t>(position);
    }
    return {cell_cones_.data() + cell_begin_[cell], cell_cones_.data() + cell_begin_[cell + 1]};
}

double TubeField::blend_width_mm(const Vessel& a, const Vessel& b) const {
    double width = 0.0;
    for (const int node : {a.proximal_node, a.distal_node})
        if (node == b.proximal_node || node == b.distal_node)
            width = std::max(width, node_blend_mm_[node]);
    return width;
}

double TubeField::distance_mm(const Vec3& point_mm) const {
    const std::span<const int> near = cones_near(point_mm);
    double distance = infinity;
    int nearest_vessel = -1;
    bool several = false;
    for (const int i : near) {
        const Cone& cone = cones_[i];
        several = several || cone.vessel != cones_[near.front()].vessel;
        const double candidate = distance_to(cone, point_mm);
        if (candidate < distance) {
            distance = candidate;
            nearest_vessel = cone.vessel;
        }
    }
    if (!several) return distance;
    const Vessel& nearest = vessels_[nearest_vessel];
    for (std::size_t i = 0; i < near.size();) {
        const int vessel = cones_[near[i]].vessel;
        double candidate = infinity;
        for (; i < near.size() && cones_[near[i]].vessel == vessel; ++i)
            candidate = std::min(candidate, distance_to(cones_[near[i]], point_mm));
        if (vessel == nearest_vessel) continue;
        const double width = blend_width_mm(nearest, vessels_[vessel]);
        if (width > 0.0) distance = smooth_minimum(distance, candidate, width);
    }
    return distance;
}

TubeField::Foot TubeField::foot_of(const Vec3& point_mm) const {
    Foot foot;
    double distance = infinity;
    for (const int i : cones_near(point_mm)) {
        const double candidate = distance_to(cones_[i], point_mm);
        if (candidate >= distance) continue;
        distance = candidate;
        foot.cone = i;
    }
    if (foot.cone < 0) return foot;
    const Cone& cone = cones_[foot.cone];
    const Vec3 axis = cone.b - cone.a;
    const double squared_length = axis.squaredNorm();
    if (squared_length > 0.0)
        foot.share = std::clamp((point_mm - cone.a).dot(axis) / squared_length, 0.0, 1.0);
    else  // a ball: a centreline that comes back to a point within half a radius
        foot.share = cone.radius_b > cone.radius_a ? 1.0 : 0.0;
    return foot;
}

double TubeField::radius_mm(const Vec3& point_mm) const {
    const Foot foot = foot_of(point_mm);
    if (foot.cone < 0) return smallest_radius_mm_;
    const Cone& cone = cones_[foot.cone];
    return (1.0 - foot.share) * cone.radius_a + foot.share * cone.radius_b;
}

double TubeField::position_along(const Vec3& point_mm) const {
    const Foot foot = foot_of(point_mm);
    return foot.cone < 0 ? 0.0 : foot.cone + foot.share;
}

std::vector<Vec3> TubeField::surface_points_mm() const {
    constexpr double spacing_in_radii = 1.5;
    std::vector<Vec3> points;
    double since_ring = infinity;
    int turn = 0;
    for (std::size_t i = 0; i < cones_.size(); ++i) {
        const Cone& cone = cones_[i];
        const double length = (cone.b - cone.a).norm();
        if (i == 0 || cones_[i - 1].vessel != cone.vessel) {
            since_ring = infinity;
            add_surface_point(cone.a, direction(cone.b, cone.a), cone.radius_a, points);
        }
        if (i + 1 == cones_.size() || cones_[i + 1].vessel != cone.vessel)
            add_surface_point(cone.b, direction(cone.a, cone.b), cone.radius_b, points);
        const double step = 0.25 * std::min(cone.radius_a, cone.radius_b);
        for (double at = 0.0; at < length; at += step, since_ring += step) {
            const double share = at / length;
            const double radius = (1.0 - share) * cone.radius_a + share * cone.radius_b;
            if (since_ring < spacing_in_radii * radius) continue;
            add_ring(cone, share, turn++, points);
            since_ring = 0.0;
        }
    }
    return points;
}

void TubeField::add_surface_point(const Vec3& centre, const Vec3& direction, double radius,
                                  std::vector<Vec3>& points) const {
    // There is no surface where a ray leaves this vessel inside another one.
    const Vec3 point = centre + radius * direction;
    if (std::abs(distance_mm(point)) < 0.05 * radius) points.push_back(point);
}

void TubeField::add_ring(const Cone& cone, double share, int turn,
                         std::vector<Vec3>& points) const {
    constexpr int around = 3;
    const Vec3 axis = cone.b - cone.a;
    const double length = axis.norm();
    const Vec3 along = axis / length;
    const Vec3 across = along.unitOrthogonal();
    const double radius = (1.0 - share) * cone.radius_a + share * cone.radius_b;
    const double tilt = (cone.radius_a - cone.radius_b) / length;
    for (int k = 0; k < around; ++k) {
        const double angle = (2.0 * k + turn % 2) * M_PI / around;
        const Vec3 radial = std::cos(angle) * across + std::sin(angle) * along.cross(across);
        add_surface_point(cone.a + share * axis, (radial + tilt * along).normalized(), radius,
                          points);
    }
}

}  // namespace hepatica
