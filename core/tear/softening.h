// SPDX-License-Identifier: GPL-3.0-or-later
// What holds the two sides of a parted joint together until it has come apart: a traction that
// rises to the strength over a short way, then falls in a line to 0 at the critical opening
// (Geubelle and Baylor 1998). The area under it is the fracture energy. It never heals: where it
// was opened further before, it goes back to 0 in a line.
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
    double most_mm = 0.0;           // the widest opening so far, >= law.peak_mm()
    Vec3 normal = Vec3::Zero();     // present, towards the second
};

// Of the law's own terms.
TieCorner corner_of(const SofteningTie& tie);

// Energy [nJ] of a tie at an opening, from its first vertex to its second. Pressed together it
// keeps its stiffness however far it was opened, so that the sides do not pass through each other;
// what has come apart is no tie.
double energy_of(const SofteningLaw& law, const SofteningTie& tie, const Vec3& opening_mm);
// Force [uN] on the first vertex; the second feels its opposite.
Vec3 force_of(const SofteningLaw& law, const SofteningTie& tie, const Vec3& opening_mm);
// Its stiffness by the secant [uN/mm], positive semidefinite.
Mat3 stiffness_of(const SofteningLaw& law, const SofteningTie& tie, const Vec3& opening_mm);
// How far it is open, in tension and across; what it is pressed together does not count.
double effective_opening_mm(const SofteningTie& tie, const Vec3& opening_mm);

}  // namespace hepatica
