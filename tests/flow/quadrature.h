// SPDX-License-Identifier: GPL-3.0-or-later
// An integral by adaptive Gauss-Kronrod (7, 15) in extended precision: the oracle of every closed
// form of the pressure drop. Nodes and weights: Piessens et al., QUADPACK (1983).
#pragma once

#include <array>
#include <cmath>

namespace hepatica::testing_flow {

using Real = long double;

template <class Integrand>
Real integrate(const Integrand& f, Real a, Real b, Real relative_tolerance, int depth = 60) {
    static constexpr std::array<Real, 8> nodes = {
        0.991455371120812639206854697526329L, 0.949107912342758524526189684047851L,
        0.864864423359769072789712788640926L, 0.741531185599394439863864773280788L,
        0.586087235467691130294144838258730L, 0.405845151377397166906606412076961L,
        0.207784955007898467600689403773245L, 0.0L};
    static constexpr std::array<Real, 8> kronrod = {
        0.022935322010529224963732008058970L, 0.063092092629978553290700663189204L,
        0.104790010322250183839876322541518L, 0.140653259715525918745189590510238L,
        0.169004726639267902826583426598550L, 0.190350578064785409913256402421014L,
        0.204432940075298892414161999234649L, 0.209482141084727828012999174891714L};
    static constexpr std::array<Real, 4> gauss = {
        0.129484966168869693270611432679082L, 0.279705391489276667901467771423780L,
        0.381830050505118944950369775488975L, 0.417959183673469387755102040816327L};
    const Real middle = (a + b) / 2;
    const Real half = (b - a) / 2;
    Real fine = 0;
    Real coarse = 0;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const Real x = half * nodes[i];
        const Real value = i == 7 ? f(middle) : f(middle - x) + f(middle + x);
        fine += kronrod[i] * value;
        if (i % 2 == 1) coarse += gauss[i / 2] * value;
    }
    fine *= half;
    coarse *= half;
    if (depth == 0 || std::fabs(fine - coarse) <= relative_tolerance * std::fabs(fine)) return fine;
    return integrate(f, a, middle, relative_tolerance, depth - 1) +
           integrate(f, middle, b, relative_tolerance, depth - 1);
}

}  // namespace hepatica::testing_flow
