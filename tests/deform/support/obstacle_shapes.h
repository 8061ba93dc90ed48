// SPDX-License-Identifier: GPL-3.0-or-later
// Obstacles for tests: balls and boxes as closed triangle surfaces, and whether a point lies in one
// by its solid angle, which shares no code with the search for contacts.
#pragma once

#include <cmath>
#include <map>
#include <memory>
#include <span>
#include <utility>

#include "core/deform/body/obstacles.h"
#include "core/mesh/brick_mesh.h"

namespace hepatica::test {

// An octahedron whose triangles are cut into four so many times, on a sphere.
inline TriangleMesh ball_surface(const Vec3& centre_mm, double radius_mm, int cuts = 3) {
    TriangleMesh mesh;
    mesh.vertices_mm = {Vec3(1, 0, 0),  Vec3(-1, 0, 0), Vec3(0, 1, 0),
                        Vec3(0, -1, 0), Vec3(0, 0, 1),  Vec3(0, 0, -1)};
    mesh.triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                      {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
    for (int cut = 0; cut < cuts; ++cut) {
        std::map<std::pair<int, int>, int> middles;
        const auto middle = [&](int a, int b) {
            const auto [at, made] =
                middles.try_emplace(std::minmax(a, b), static_cast<int>(mesh.vertices_mm.size()));
            if (made)
                mesh.vertices_mm.push_back(
                    (mesh.vertices_mm[a] + mesh.vertices_mm[b]).normalized());
            return at->second;
        };
        std::vector<std::array<int, 3>> finer;
        for (const auto& [a, b, c] : mesh.triangles) {
            const int ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
            finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
        }
        mesh.triangles = std::move(finer);
    }
    for (Vec3& x : mesh.vertices_mm) x = centre_mm + radius_mm * x;
    return mesh;
}

// A box with this lowest corner, cut into cells.
inline TriangleMesh box_surface(const Vec3& low_mm, const Vec3& size_mm, const Index3& cells) {
    TetMesh box = kuhn_brick(size_mm, cells);
    TriangleMesh mesh{std::move(box.vertices_mm), boundary_triangles(box)};
    for (Vec3& x : mesh.vertices_mm) x += low_mm;
    return mesh;
}

inline std::shared_ptr<const Obstacles> one_obstacle(TriangleMesh surface, double friction = 0.2,
                                                     SurfaceKind kind = SurfaceKind::solid) {
    return std::make_shared<const Obstacles>(
        Obstacles{{Obstacle{std::move(surface), kind}}, friction});
}

// How often the surface winds around the point: 1 inside, 0 outside (Van Oosterom and Strackee).
inline double winding(const TriangleMesh& surface, const Vec3& point) {
    double angle = 0.0;
    for (const auto& [i, j, k] : surface.triangles) {
        const Vec3 a = surface.vertices_mm[i] - point, b = surface.vertices_mm[j] - point,
                   c = surface.vertices_mm[k] - point;
        const double la = a.norm(), lb = b.norm(), lc = c.norm();
        angle += 2.0 * std::atan2(a.dot(b.cross(c)),
                                  la * lb * lc + a.dot(b) * lc + a.dot(c) * lb + b.dot(c) * la);
    }
    return angle / (4.0 * M_PI);
}

inline int points_inside(const TriangleMesh& surface, std::span<const Vec3> points) {
    int inside = 0;
    for (const Vec3& x : points) inside += winding(surface, x) > 0.5 ? 1 : 0;
    return inside;
}

}  // namespace hepatica::test
