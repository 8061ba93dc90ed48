// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/flow/tube_law.h"

#include <cmath>
#include <numbers>

namespace hepatica {

double open_share(double excess_pa, const TubeWall& wall) {
    if (!(excess_pa > 0.0)) return 1.0;
    const double slenderness = wall.thickness_per_radius;
    const double bending_pa = wall.young_modulus_pa * slenderness * slenderness * slenderness /
                              (12.0 * (1.0 - wall.poisson_ratio * wall.poisson_ratio));
    const double pressed = excess_pa / bending_pa;
    // The law falls monotonically; its solution lies between that without the term a^10 and 1.
    double low = std::pow(1.0 + pressed, -2.0 / 3.0), high = 1.0;
    constexpr int halvings = 60;
    for (int i = 0; i < halvings; ++i) {
        const double middle = 0.5 * (low + high);
        const double resists = std::pow(middle, -1.5) - std::pow(middle, 10.0);
        (resists > pressed ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

double slit_mm2(double length_mm, double pressure_pa, const TubeWall& wall) {
    if (!(pressure_pa > 0.0)) return 0.0;
    const double hoop_pa = pressure_pa / wall.thickness_per_radius;
    return 0.5 * std::numbers::pi * length_mm * length_mm * hoop_pa / wall.young_modulus_pa;
}

double jet_loss(double share) {
    const double contraction = 0.62 + 0.38 * share * share * share;
    const double lost = 1.0 / contraction - share;
    return lost * lost;
}

}  // namespace hepatica
