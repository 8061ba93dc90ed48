// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tear/softening.h"

#include <algorithm>

namespace hepatica {

double SofteningLaw::unloading_pa_mm(double most_mm) const {
    const double most = std::max(most_mm, peak_mm());
    if (most >= opening_mm) return 0.0;
    return strength_pa * (opening_mm - most) / ((opening_mm - peak_mm()) * most);
}

double SofteningLaw::secant_pa_mm(double opening, double most_mm) const {
    return unloading_pa_mm(std::max(opening, most_mm));
}

double SofteningLaw::traction_pa(double opening, double most_mm) const {
    return secant_pa_mm(opening, most_mm) * opening;
}

double SofteningLaw::energy_un_mm(double opening, double most_mm) const {
    const double most = std::clamp(most_mm, peak_mm(), opening_mm);
    const double inside = std::min(opening, most);
    double energy = 0.5 * unloading_pa_mm(most) * inside * inside;
    if (opening > most) {
        const double before = opening_mm - most;
        const double after = opening_mm - std::min(opening, opening_mm);
        energy += 0.5 * strength_pa / (opening_mm - peak_mm()) * (before * before - after * after);
    }
    return energy;
}

namespace {

// Along the normal, negative where the sides are pressed into each other; and all of the opening
// that counts as such.
struct Parts {
    double pressed_mm = 0.0;  // <= 0
    Vec3 open_mm = Vec3::Zero();
};

Parts parts_of(const SofteningTie& tie, const Vec3& opening_mm) {
    const double along = std::min(0.0, opening_mm.dot(tie.normal));
    return {along, opening_mm - along * tie.normal};
}

double pressed_stiffness(const SofteningLaw& law) {
    return law.unloading_pa_mm(law.peak_mm());
}

}  // namespace

double effective_opening_mm(const SofteningTie& tie, const Vec3& opening_mm) {
    return parts_of(tie, opening_mm).open_mm.norm();
}

// What has come apart does not feel itself.
double energy_of(const SofteningLaw& law, const SofteningTie& tie, const Vec3& opening_mm) {
    if (tie.most_mm >= law.opening_mm) return 0.0;
    const auto [pressed, open] = parts_of(tie, opening_mm);
    return tie.area_mm2 * (law.energy_un_mm(open.norm(), tie.most_mm) +
                           0.5 * pressed_stiffness(law) * pressed * pressed);
}

Vec3 force_of(const SofteningLaw& law, const SofteningTie& tie, const Vec3& opening_mm) {
    if (tie.most_mm >= law.opening_mm) return Vec3::Zero();
    const auto [pressed, open] = parts_of(tie, opening_mm);
    return tie.area_mm2 * (law.secant_pa_mm(open.norm(), tie.most_mm) * open +
                           pressed_stiffness(law) * pressed * tie.normal);
}

Mat3 stiffness_of(const SofteningLaw& law, const SofteningTie& tie, const Vec3& opening_mm) {
    if (tie.most_mm >= law.opening_mm) return Mat3::Zero();
    const auto [pressed, open] = parts_of(tie, opening_mm);
    const double secant = law.secant_pa_mm(open.norm(), tie.most_mm);
    Mat3 stiffness = secant * Mat3::Identity();
    if (pressed < 0.0)
        stiffness += (pressed_stiffness(law) - secant) * tie.normal * tie.normal.transpose();
    return tie.area_mm2 * stiffness;
}

}  // namespace hepatica
