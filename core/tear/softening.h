// SPDX-License-Identifier: GPL-3.0-or-later
// The cohesive law of parted joints: a traction that rises to the strength over a short opening,
// then falls linearly to 0 at the critical opening (Geubelle and Baylor 1998). The area under it is
// the fracture energy. Damage does not heal: after a wider opening, the traction returns linearly
// to 0.
#pragma once

#include <array>

#include "core/base/vector.h"
#include "core/tear/softening_law.h"

namespace hepatica {

// One corner of a parted joint: two vertices that were one, and a third of the joint's area.
struct SofteningTie {
    std::array<int, 2> vertices{};  // of the joint's first and second tetrahedron
    std::array<int, 3> triangle{};  // the first tetrahedron's face: gives the present normal
    double area_mm2 = 0.0;          // times the joint's tear factor
    double most_mm = 0.0;           // the largest opening so far, >= law.peak_mm()
    Vec3 normal = Vec3::Zero();     // present, towards the second
};

// The tie in the terms of softening_law.h.
TieCorner corner_of(const SofteningTie& tie);

// Energy [nJ] of a tie at an opening from its first vertex to its second. In compression it keeps
// its initial stiffness whatever its damage, so that the sides do not pass through each other; a
// tie that has come apart stores nothing.
double energy_of(const SofteningLaw& law, const SofteningTie& tie, const Vec3& opening_mm);
// Force [uN] on the first vertex; the second feels the opposite.
Vec3 force_of(const SofteningLaw& law, const SofteningTie& tie, const Vec3& opening_mm);
// Secant stiffness [uN/mm], positive semidefinite.
Mat3 stiffness_of(const SofteningLaw& law, const SofteningTie& tie, const Vec3& opening_mm);
// Opening in tension and shear; compression does not count.
double effective_opening_mm(const SofteningTie& tie, const Vec3& opening_mm);

}  // namespace hepatica
