// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/vessel_body.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/mesh/brick_mesh.h"
#include "core/mesh/tetrahedralize.h"

namespace hepatica {

namespace {

constexpr double bar_width_mm = 6.0;

struct Growth {
    Vec3 direction;
    Vec3 side;
    int generation = 0;
};

int add_branch(VesselTree& tree, int parent, int from_node, const Vec3& direction, double radius,
               double length) {
    VesselSegment segment;
    segment.parent = parent;
    segment.proximal_node = from_node;
    segment.distal_node = static_cast<int>(tree.nodes.size());
    constexpr int pieces = 8;
    for (int k = 0; k <= pieces; ++k) {
        segment.points_mm.push_back(tree.nodes[from_node].position_mm +
                                    length * k / pieces * direction);
        segment.radii_mm.push_back(radius);
    }
    tree.nodes.push_back({segment.points_mm.back(), radius});
    tree.segments.push_back(segment);
    return static_cast<int>(tree.segments.size()) - 1;
}

}  // namespace

BodyDescription study_bar(double slenderness, int cells_across) {
    const double length = slenderness * bar_width_mm;
    const int along = static_cast<int>(std::lround(slenderness * cells_across));
    BodyDescription body;
    body.mesh = kuhn_brick(Vec3(length, bar_width_mm, bar_width_mm),
                           Index3{along, cells_across, cells_across});
    for (Vec3& x : body.mesh.vertices_mm) {
        x -= Vec3(0.0, 0.5 * bar_width_mm, 0.5 * bar_width_mm);
        body.fixed.push_back(x.x() < 1e-9 * length ? 1 : 0);
    }
    const SkeletonPolyline line{
        {Vec3::Zero(), Vec3(length, 0.0, 0.0)}, {0.5 * bar_width_mm, 0.5 * bar_width_mm}, -1};
    body.skeleton = resample(std::span(&line, 1));
    return body;
}

VesselTree study_tree(int generations, double root_radius_mm) {
    const double murray = std::pow(2.0, -1.0 / 3.0);
    VesselTree tree;
    tree.nodes.push_back({Vec3::Zero(), root_radius_mm});
    std::vector<Growth> growth{{Vec3::UnitX(), Vec3::UnitY(), 0}};
    add_branch(tree, -1, 0, Vec3::UnitX(), root_radius_mm, 10.0 * root_radius_mm);
    for (std::size_t s = 0; s < tree.segments.size(); ++s) {
        const Growth now = growth[s];
        if (now.generation + 1 >= generations) continue;
        const double radius = murray * tree.segments[s].radii_mm[0];
        for (const double turn : {0.65, -0.55}) {
            const Vec3 direction =
                (std::cos(turn) * now.direction + std::sin(turn) * now.side).normalized();
            add_branch(tree, static_cast<int>(s), tree.segments[s].distal_node, direction, radius,
                       14.0 * radius);
            growth.push_back(
                {direction, now.direction.cross(now.side).normalized(), now.generation + 1});
        }
    }
    return tree;
}

CoarseSkeleton skeleton_of(const VesselTree& tree) {
    std::vector<SkeletonPolyline> lines;
    for (const VesselSegment& segment : tree.segments) {
        lines.push_back({segment.points_mm, segment.radii_mm, segment.parent});
    }
    return resample(lines);
}

BodyDescription body_of(const VesselTree& tree, int tetrahedra, Job& job) {
    BodyDescription body;
    MeshOptions options;
    options.target_tetrahedra = tetrahedra;
    body.mesh = tetrahedralize(tree, options, job);
    body.skeleton = skeleton_of(tree);
    body.fixed.assign(body.mesh.vertices_mm.size(), 0);
    for (const int root : roots(tree)) {
        const VesselSegment& segment = tree.segments[root];
        const Vec3 inward = (segment.points_mm[1] - segment.points_mm[0]).normalized();
        for (std::size_t v = 0; v < body.fixed.size(); ++v) {
            const Vec3 arm = body.mesh.vertices_mm[v] - segment.points_mm[0];
            const double radius = segment.radii_mm[0];
            if (arm.norm() < 2.0 * radius && arm.dot(inward) < 0.5 * radius) body.fixed[v] = 1;
        }
    }
    return body;
}

Vec3 clamp_mm(const BodyDescription& body) {
    Vec3 clamp = Vec3::Zero();
    int clamped = 0;
    for (std::size_t v = 0; v < body.fixed.size(); ++v) {
        if (!body.fixed[v]) continue;
        clamp += body.mesh.vertices_mm[v];
        ++clamped;
    }
    return clamp / std::max(clamped, 1);
}

int furthest_vertex(const BodyDescription& body) {
    const std::vector<Vec3>& x = body.mesh.vertices_mm;
    const Vec3 clamp = clamp_mm(body);
    std::size_t furthest = 0;
    for (std::size_t v = 0; v < x.size(); ++v)
        if ((x[v] - clamp).norm() > (x[furthest] - clamp).norm()) furthest = v;
    return static_cast<int>(furthest);
}

Grab led_around(int vertex, const Vec3& start_mm, int frame) {
    const double angle = 0.05 * frame;
    Grab grab;
    grab.vertices[0] = vertex;
    grab.target_mm = start_mm + Vec3(0.0, 2.0 * std::sin(angle), 2.0 - 2.0 * std::cos(angle));
    grab.stiffness_un_per_mm = 2e4;
    grab.force_limit_un = 1e5;
    return grab;
}

std::vector<Vec3> bent(std::vector<Vec3> positions_mm, double angle_rad) {
    double length = 0.0;
    for (const Vec3& x : positions_mm) length = std::max(length, x.x());
    const double radius = length / angle_rad;
    for (Vec3& x : positions_mm) {
        const double angle = x.x() / radius;
        x = Vec3((radius - x.y()) * std::sin(angle), radius - (radius - x.y()) * std::cos(angle),
                 x.z());
    }
    return positions_mm;
}

}  // namespace hepatica
