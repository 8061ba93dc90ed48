// SPDX-License-Identifier: GPL-3.0-or-later
// Coulomb's friction at one contact, as the potential of one step: a contact of the normal force N
// that slips by y takes
//   mu N (y - e/3) of energy,   and  mu N (y^2/e - y^3/(3 e^2)) where y < e,
// whose force grows to mu N over the creep e and is mu N beyond (Li et al. 2020, eq. 15). The
// stiffness is exact of what sticks and of what slips on. What slips but is about to stick would by
// that go past the point where it sticks, however far, and the energy's kink there would cut the
// whole body's step to nothing. So its stiffness is mu N / y in all directions of the plane: the
// least that bounds the energy from above, so that no step goes too far. For host and device.
#pragma once

#include "core/base/small_matrix.h"

namespace hepatica {

// What slips is about to stick where the other forces on it fall short of friction by this share.
inline constexpr double slowing_share = 0.05;

// Of a motion what lies along a surface with this normal.
HEPATICA_HOST_DEVICE small::Vector3<double> slip_of(const small::Vector3<double>& moved,
                                                    const small::Vector3<double>& normal) {
    return moved - small::dot(moved, normal) * normal;
}

struct SlipLaw {
    double limit_un;  // mu N
    double creep_mm;  // e > 0

    HEPATICA_HOST_DEVICE double energy_nj(const small::Vector3<double>& slip_mm) const {
        const double y = std::sqrt(small::dot(slip_mm, slip_mm)), e = creep_mm;
        return limit_un * (y < e ? y * y / e * (1.0 - y / (3.0 * e)) : y - e / 3.0);
    }
    HEPATICA_HOST_DEVICE small::Vector3<double> force_un(
        const small::Vector3<double>& slip_mm) const {
        const double y = std::sqrt(small::dot(slip_mm, slip_mm)), e = creep_mm;
        return (y < e ? -limit_un / e * (2.0 - y / e) : -limit_un / y) * slip_mm;
    }
    HEPATICA_HOST_DEVICE small::Matrix3<double> stiffness_un_per_mm(
        const small::Vector3<double>& slip_mm, const small::Vector3<double>& normal,
        bool slows) const {
        const double y = std::sqrt(small::dot(slip_mm, slip_mm)), e = creep_mm;
        const auto plane = small::identity_matrix<double>() - small::outer(normal, normal);
        if (y == 0.0) return 2.0 * limit_un / e * plane;
        small::Vector3<double> s;
        for (int c = 0; c < 3; ++c) s[c] = slip_mm[c] / y;
        const double across = y < e ? (2.0 - y / e) / e : 1.0 / y;
        const double along = y < e ? 2.0 * (1.0 - y / e) / e : (slows ? 1.0 / y : 0.0);
        return limit_un * (across * (plane - small::outer(s, s)) + small::outer(along * s, s));
    }
};

}  // namespace hepatica
