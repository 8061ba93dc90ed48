// SPDX-License-Identifier: GPL-3.0-or-later
// What tests of tools need: a bar to be touched, and what must hold of any tool beside a body.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/deform/body/body.h"
#include "core/deform/stepper/stepper.h"
#include "core/mesh/brick_mesh.h"
#include "core/mesh/surface.h"

namespace hepatica::test {

// Along x, 60 x 6 x 6 mm, clamped at both ends.
inline BodyDescription bar() {
    BodyDescription body;
    body.mesh = kuhn_brick(Vec3(60, 6, 6), {20, 2, 2});
    for (const Vec3& x : body.mesh.vertices_mm) body.fixed.push_back(x[0] == 0.0 || x[0] == 60.0);
    body.touchable = true;
    return body;
}

// 12 x 8 x 8 mm, held by nothing, without damping.
inline BodyDescription free_brick() {
    BodyDescription body;
    body.mesh = kuhn_brick(Vec3(12, 8, 8), {6, 4, 4});
    body.material.damping_ratio = 0.0;
    body.touchable = true;
    return body;
}

// Of the tool to the surface; below 0 where a triangle is in it.
inline double least_gap(const Stepper& stepper, const SurfacePatches& surface) {
    double least = INFINITY;
    for (const ToolPart& part : stepper.tool()->parts)
        for (const auto& triangle : surface.triangles()) {
            const Triangle corners = corners_of(triangle, stepper.positions_mm());
            const double distance = std::sqrt(closest(part.shape.axis(), corners).squared_mm2);
            least = std::min(least, distance - part.shape.radius_mm);
        }
    return least;
}

// Whether the point lies in a tetrahedron.
inline bool inside(const TetMesh& mesh, std::span<const Vec3> x, const Vec3& point) {
    for (const auto& t : mesh.tetrahedra) {
        bool in = true;
        for (int face = 0; face < 4 && in; ++face) {
            std::array<Vec3, 4> corners{x[t[0]], x[t[1]], x[t[2]], x[t[3]]};
            const double whole = signed_volume_mm3(corners[0], corners[1], corners[2], corners[3]);
            corners[face] = point;
            in = whole * signed_volume_mm3(corners[0], corners[1], corners[2], corners[3]) > 0.0;
        }
        if (in) return true;
    }
    return false;
}

// Whether an end of a part of the tool lies in the body.
inline bool ends_inside(const Stepper& stepper, const TetMesh& mesh) {
    for (const ToolPart& part : stepper.tool()->parts)
        for (const Vec3& end : part.shape.axis())
            if (inside(mesh, stepper.positions_mm(), end)) return true;
    return false;
}

inline Vec3 momentum(const Stepper& stepper, const Body& body) {
    Vec3 sum = Vec3::Zero();
    for (int i = 0; i < body.node_count(); ++i)
        sum += body.mass_g[i] * stepper.velocities_mm_per_s()[i];
    return sum;
}

}  // namespace hepatica::test
