// SPDX-License-Identifier: GPL-3.0-or-later
// The hand that pulls at a vessel: it closes around some vertices and holds each by a spring whose
// force is limited (core/deform/potentials/grab.h). Together the springs are as stiff as the
// vessel.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/base/hash.h"
#include "core/base/vector.h"
#include "core/deform/potentials/grab.h"
#include "core/scene/body_vertices.h"
#include "core/scene/frame.h"

namespace hepatica {

// The hand, closed around some vertices.
struct Hold {
    std::vector<int> vertices;
    std::vector<Vec3> offsets_mm;  // from the held point, when the hand closed
    Vec3 target_mm = Vec3::Zero();
    double stiffness_un_per_mm = 0.0;  // of each spring
    double force_limit_un = 0.0;       // of each spring
};

// The functions below only read what they are given; thread-safe.

// The hand closed around a vertex, with the held point and the target at point_mm: it holds every
// vertex within about a vessel's radius that is not fixed, at least the vertex itself. modulus_pa
// is the tissue's; pressure_pa is the hand's greatest pressure over the vessel's section.
Hold hold_around(int vertex, const Vec3& point_mm, const BodyVertices& body,
                 std::span<const Vec3> positions_mm, double modulus_pa, double pressure_pa);

// One spring for each held vertex.
std::vector<Grab> springs_of(const Hold& hold);

// As it is shown, at these positions of the body.
GrabView view_of(const Hold& hold, std::span<const Vec3> positions_mm);

// Throws InputError, as of a checkpoint of another patient, unless the hold is of a body with so
// many vertices.
void require_hold_of(std::size_t vertices, const Hold& hold);

// Everything that determines the springs.
void add_to(Hasher& hasher, const Hold& hold);

}  // namespace hepatica
