// SPDX-License-Identifier: GPL-3.0-or-later
// Bars that tear, and how tests hold and pull them.
#pragma once

#include <vector>

#include "core/deform/body/body.h"
#include "core/deform/stepper/cpu_stepper.h"
#include "core/mesh/brick_mesh.h"

namespace hepatica::test {

inline BodyDescription bar(const Vec3& size_mm, const Index3& cells, const TearLaw& law,
                           double young_modulus_pa = 0.5e6) {
    BodyDescription body;
    body.mesh = kuhn_brick(size_mm, cells);
    body.material.young_modulus_pa = young_modulus_pa;
    body.material.poisson_ratio = 0.3;
    body.fixed.assign(body.mesh.vertices_mm.size(), 0);
    body.tear = law;
    return body;
}

inline void clamp_at_0(BodyDescription& body) {
    for (std::size_t v = 0; v < body.fixed.size(); ++v)
        body.fixed[v] = body.mesh.vertices_mm[v].x() < 1e-9;
}

inline Grab spring(int vertex, const Vec3& target_mm, double stiffness = 1e6) {
    Grab grab;
    grab.vertices[0] = vertex;
    grab.target_mm = target_mm;
    grab.stiffness_un_per_mm = stiffness;
    grab.force_limit_un = 1e12;
    return grab;
}

// Every vertex of the far end is led by (x, 0, 0).
inline std::vector<Grab> pull_of(const BodyDescription& body, double length_mm, double x_mm) {
    std::vector<Grab> grabs;
    for (std::size_t v = 0; v < body.mesh.vertices_mm.size(); ++v)
        if (body.mesh.vertices_mm[v].x() > length_mm - 1e-9)
            grabs.push_back(
                spring(static_cast<int>(v), body.mesh.vertices_mm[v] + Vec3(x_mm, 0, 0)));
    return grabs;
}

}  // namespace hepatica::test
