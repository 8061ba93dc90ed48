// SPDX-License-Identifier: GPL-3.0-or-later
// Rigid, fixed surfaces that a body touches; see ObstacleContact.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/contact/surface_features.h"
#include "core/mesh/tet_mesh.h"

namespace hepatica {

struct Obstacle {
    TriangleMesh surface;                   // closed, counter-clockwise from outside
    SurfaceKind kind = SurfaceKind::solid;  // or a shell, which keeps in whatever is inside it
};

struct Obstacles {
    std::vector<Obstacle> all;  // at least one
    double friction = 0.2;      // Coulomb's coefficient, >= 0
};

// The surfaces of the obstacles appended to that of a body: nodes and triangles of the body first.
struct WithObstacles {
    std::vector<Vec3> positions_mm;
    std::vector<std::array<int, 3>> triangles;
    std::vector<SurfaceKind> kinds;  // of each node
};
WithObstacles with_obstacles(const Obstacles& obstacles, std::span<const Vec3> positions_mm,
                             std::span<const std::array<int, 3>> triangles);

// Throws InputError where there is no obstacle, a surface is not closed or not finite, or the
// friction is out of range.
void validate(const Obstacles& obstacles);

}  // namespace hepatica
