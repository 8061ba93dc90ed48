// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tear/softening.h"

#include "core/base/small_matrix_eigen.h"

namespace hepatica {
namespace {

TiePull pull_at(const SofteningLaw& law, const SofteningTie& tie, const Vec3& opening_mm) {
    return pull_of(law, corner_of(tie), small::from_eigen(opening_mm));
}

}  // namespace

TieCorner corner_of(const SofteningTie& tie) {
    return {tie.area_mm2, tie.most_mm, small::from_eigen(tie.normal)};
}

double effective_opening_mm(const SofteningTie& tie, const Vec3& opening_mm) {
    return effective_opening_mm(corner_of(tie), small::from_eigen(opening_mm));
}

double energy_of(const SofteningLaw& law, const SofteningTie& tie, const Vec3& opening_mm) {
    return pull_at(law, tie, opening_mm).energy_nj;
}

Vec3 force_of(const SofteningLaw& law, const SofteningTie& tie, const Vec3& opening_mm) {
    return small::to_eigen(pull_at(law, tie, opening_mm).force_un);
}

Mat3 stiffness_of(const SofteningLaw& law, const SofteningTie& tie, const Vec3& opening_mm) {
    return small::to_eigen(pull_at(law, tie, opening_mm).stiffness_un_per_mm);
}

}  // namespace hepatica
