// SPDX-License-Identifier: GPL-3.0-or-later
// Rigid surfaces that stand where they are and that a body touches: see ObstacleContact.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/contact/surface_features.h"
#include "core/mesh/tet_mesh.h"

namespace hepatica {

struct Obstacle {
    TriangleMesh surface;                   // closed, counter-clockwise from outside
    SurfaceKind kind = SurfaceKind::solid;  // or a shell: nothing that is in it gets out
};

struct Obstacles {
    std::vector<Obstacle> all;  // one or more
    double friction = 0.2;      // Coulomb's coefficient, >= 0
};

// Surfaces of obstacles behind that of a body: all nodes, those of the body first, and triangles.
struct WithObstacles {
    std::vector<Vec3> positions_mm;
    std::vector<std::array<int, 3>> triangles;
    std::vector<SurfaceKind> kinds;  // of each node
};
WithObstacles with_obstacles(const Obstacles& obstacles, std::span<const Vec3> positions_mm,
                             std::span<const std::array<int, 3>> triangles);

// Throws InputError where there are none, a surface is not closed or not finite, or the friction is
// out of range.
void validate(const Obstacles& obstacles);

}  // namespace hepatica
