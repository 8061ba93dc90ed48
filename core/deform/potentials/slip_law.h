// SPDX-License-Identifier: GPL-3.0-or-later
// Coulomb friction at one contact, as the potential of one step. A contact with normal force N that
// slips by y stores
//   mu N (y - e/3),   and  mu N (y^2/e - y^3/(3 e^2)) where y < e,
// so its force grows to mu N over the creep e and stays mu N beyond (Li et al. 2020, eq. 15). The
// stiffness is exact for contacts that stick and for those that keep slipping. For a contact that
// is about to stick, the exact stiffness along the slip is zero: Newton's step would go far past
// the sticking point, and the energy's kink there would shorten the whole body's step to almost
// nothing. Its stiffness is therefore mu N / y in all tangential directions, the least for which
// the quadratic model bounds the energy from above. For host and device.
#pragma once

#include "core/base/small_matrix.h"

namespace hepatica {

// A slipping point is about to stick where the other forces fall short of friction by this share.
inline constexpr double slowing_share = 0.05;

// The tangential part of a motion along a surface with this normal.
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
