// SPDX-License-Identifier: GPL-3.0-or-later
// The law of softening.h for host and device: the traction of a parted joint, and the force of one
// of its corners.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/base/small_matrix.h"

namespace hepatica {

// For a joint with tear factor 1, per rest area.
struct SofteningLaw {
    double strength_pa = 0.0;  // > 0
    double opening_mm = 0.0;   // critical opening, > 0: 2 * fracture energy / strength
    // The share of the critical opening over which the traction rises. Its slope is the stiffness
    // of undamaged ties: stiff enough not to affect bending, soft enough for single precision.
    static constexpr double rise = 0.02;

    HEPATICA_HOST_DEVICE double peak_mm() const { return rise * opening_mm; }
    HEPATICA_HOST_DEVICE double fracture_energy_j_m2() const {
        return 0.5e-3 * strength_pa * opening_mm;
    }
    // Energy per area [uN/mm] at an opening >= 0 of a joint whose largest opening so far is
    // `most_mm`: the stored part, plus what is given up beyond that opening.
    HEPATICA_HOST_DEVICE double energy_un_mm(double opening, double most_mm) const {
        const double most = std::clamp(most_mm, peak_mm(), opening_mm);
        const double inside = std::min(opening, most);
        double energy = 0.5 * unloading_pa_mm(most) * inside * inside;
        if (opening > most) {
            const double before = opening_mm - most;
            const double after = opening_mm - std::min(opening, opening_mm);
            energy +=
                0.5 * strength_pa / (opening_mm - peak_mm()) * (before * before - after * after);
        }
        return energy;
    }
    // Traction over opening [Pa/mm], continued to opening 0.
    HEPATICA_HOST_DEVICE double secant_pa_mm(double opening, double most_mm) const {
        return unloading_pa_mm(std::max(opening, most_mm));
    }
    HEPATICA_HOST_DEVICE double unloading_pa_mm(double most_mm) const {
        const double most = std::max(most_mm, peak_mm());
        if (most >= opening_mm) return 0.0;
        return strength_pa * (opening_mm - most) / ((opening_mm - peak_mm()) * most);
    }
};

// One corner of a parted joint, see SofteningTie, at an opening from its first vertex to its
// second.
struct TieCorner {
    double area_mm2, most_mm;
    small::Vector3<double> normal;
};

// Compression along the normal, <= 0.
HEPATICA_HOST_DEVICE double pressed_mm(const TieCorner& tie,
                                       const small::Vector3<double>& opening_mm) {
    return std::min(0.0, small::dot(opening_mm, tie.normal));
}
// Opening in tension and shear; compression does not count.
HEPATICA_HOST_DEVICE double effective_opening_mm(const TieCorner& tie,
                                                 const small::Vector3<double>& opening_mm) {
    const auto open = opening_mm - pressed_mm(tie, opening_mm) * tie.normal;
    return std::sqrt(small::dot(open, open));
}

struct TiePull {
    double energy_nj = 0.0;
    small::Vector3<double> force_un{};             // on the first vertex
    small::Matrix3<double> stiffness_un_per_mm{};  // secant
};

// In compression the tie keeps its initial stiffness whatever its damage, so that the sides do not
// pass through each other. A tie that has come apart exerts no force.
HEPATICA_HOST_DEVICE TiePull pull_of(const SofteningLaw& law, const TieCorner& tie,
                                     const small::Vector3<double>& opening_mm) {
    TiePull pull;
    if (tie.most_mm >= law.opening_mm) return pull;
    const double pressed = pressed_mm(tie, opening_mm);
    const small::Vector3<double> open = opening_mm - pressed * tie.normal;
    const double length = effective_opening_mm(tie, opening_mm);
    const double against = law.unloading_pa_mm(law.peak_mm());
    const double secant = law.secant_pa_mm(length, tie.most_mm);
    pull.energy_nj =
        tie.area_mm2 * (law.energy_un_mm(length, tie.most_mm) + 0.5 * against * pressed * pressed);
    pull.force_un = tie.area_mm2 * (secant * open + against * pressed * tie.normal);
    auto stiffness = secant * small::identity_matrix<double>();
    if (pressed < 0.0)
        stiffness = stiffness + small::outer((against - secant) * tie.normal, tie.normal);
    pull.stiffness_un_per_mm = tie.area_mm2 * stiffness;
    return pull;
}

}  // namespace hepatica
