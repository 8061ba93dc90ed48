// SPDX-License-Identifier: GPL-3.0-or-later
// Bodies whose surfaces come near each other: boxes, a bar that bends, and loose triangles with
// capsules among them.
#pragma once

#include <random>

#include "core/contact/capsule.h"
#include "core/contact/surface_features.h"
#include "core/mesh/brick_mesh.h"
#include "tests/contact/random_features.h"

namespace hepatica::test {

// Boxes of 6 x 2 x 2 mm, moved and turned about z.
struct Boxes {
    TetMesh mesh;
    void add(const Vec3& at_mm, double angle_rad, double size = 1.0) {
        TetMesh box = kuhn_brick(size * Vec3(6, 2, 2), {3, 1, 1});
        const Eigen::AngleAxisd turn(angle_rad, Vec3::UnitZ());
        const int first = static_cast<int>(mesh.vertices_mm.size());
        for (const Vec3& x : box.vertices_mm)
            mesh.vertices_mm.push_back(turn * (x - size * Vec3(3, 1, 1)) + at_mm);
        for (auto nodes : box.tetrahedra) {
            for (int& node : nodes) node += first;
            mesh.tetrahedra.push_back(nodes);
        }
    }
    SurfaceFeatures features(int in_patch = 8) const {
        return {SurfacePatches(boundary_triangles(mesh), in_patch), mesh.vertices_mm};
    }
};

// A long bar of 12 x 1 x 1 mm with its nodes jittered.
struct Bar {
    TetMesh mesh = kuhn_brick(Vec3(12, 1, 1), {24, 2, 2});
    std::vector<Vec3> rest;
    explicit Bar(std::mt19937& random) {
        std::uniform_real_distribution<double> in(-0.08, 0.08);
        for (Vec3& x : mesh.vertices_mm) x += Vec3(in(random), in(random), in(random));
        rest = mesh.vertices_mm;
    }
    // Bent into an arc of this curvature, turned and carried away.
    std::vector<Vec3> bent(double curvature_per_mm, const Eigen::AngleAxisd& turn,
                           const Vec3& way_mm) const {
        std::vector<Vec3> x;
        for (const Vec3& r : rest) {
            const double radius = 1.0 / curvature_per_mm - r.y(), angle = r.x() * curvature_per_mm;
            const Vec3 on_arc(radius * std::sin(angle),
                              1.0 / curvature_per_mm - radius * std::cos(angle), r.z());
            x.push_back(turn * on_arc + way_mm);
        }
        return x;
    }
};

struct Soup {
    std::vector<Vec3> vertices;
    SurfacePatches surface;
};

inline Soup soup_of(RandomFeatures& random, int triangles, double size) {
    std::vector<Vec3> vertices;
    std::vector<std::array<int, 3>> corners;
    for (int t = 0; t < triangles; ++t) {
        const Vec3 at = random.point(size);
        for (int a = 0; a < 3; ++a) vertices.push_back(at + random.point(1.5));
        corners.push_back({3 * t, 3 * t + 1, 3 * t + 2});
    }
    return {vertices, SurfacePatches(corners)};
}

inline Capsule capsule_of(RandomFeatures& random) {
    Capsule capsule;
    capsule.radius_mm = random.in(0.3, 1.5);
    if (random.whole(2) == 0) capsule.half_axis_mm = random.point(2);
    return capsule;
}

}  // namespace hepatica::test
