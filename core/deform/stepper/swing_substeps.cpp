// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/stepper/swing_substeps.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace hepatica {
namespace {

// Of the mean edge at rest, that a substep may miss.
constexpr double most_missed_edges = 0.35;

double whole_mass_g(const Body& body) {
    return std::accumulate(body.mass_g.begin(), body.mass_g.end(), 0.0);
}

}  // namespace

// E = m v²/2, with g, mm/s and nJ.
void SwingSubsteps::let_go(const Body& body, double energy_nj) {
    if (energy_nj > 0.0) change_mm_per_s_ = std::sqrt(2.0 * energy_nj / whole_mass_g(body));
}

int SwingSubsteps::count(const Body& body, double dt_s, int most) const {
    const double missed_edges = 0.5 * dt_s * change_mm_per_s_ / body.mean_edge_mm;
    const double parts = std::ceil(missed_edges / most_missed_edges);
    return static_cast<int>(std::clamp(parts, 1.0, static_cast<double>(most)));
}

void SwingSubsteps::watch(const Body& body, std::span<const Vec3> velocities_before,
                          const BodyState& state, int substeps) {
    if (substeps == 1) return hold();
    double squares = 0.0;
    for (std::size_t i = 0; i < velocities_before.size(); ++i)
        squares +=
            body.mass_g[i] * (state.velocities_mm_per_s[i] - velocities_before[i]).squaredNorm();
    change_mm_per_s_ = std::sqrt(squares / whole_mass_g(body));
}

}  // namespace hepatica
