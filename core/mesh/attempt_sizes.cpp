// SPDX-License-Identifier: GPL-3.0-or-later
// Scales the sizes, and looks up the factor of the radii that was measured for a size.
#include "core/mesh/attempt_sizes.h"

#include <algorithm>
#include <array>
#include <utility>

#include "core/mesh/manifold_attempts.h"

namespace hepatica {

namespace {

// A polyhedron inscribed in a tube has less volume than the tube. The tube is widened by this
// factor, depending on the facet size in radii, so that the polyhedron has the right volume.
// Measured on branching trees without compensation; the tests check the volume to a few per cent.
double radius_factor(double facet_in_radii) {
    constexpr std::array<std::pair<double, double>, 8> measured{{{0.3, 1.012},
                                                                 {0.4, 1.020},
                                                                 {0.5, 1.029},
                                                                 {0.6, 1.041},
                                                                 {0.7, 1.069},
                                                                 {0.8, 1.099},
                                                                 {0.9, 1.102},
                                                                 {1.0, 1.103}}};
    std::size_t i = 1;
    while (i + 1 < measured.size() && measured[i].first < facet_in_radii) ++i;
    const auto& [size_a, factor_a] = measured[i - 1];
    const auto& [size_b, factor_b] = measured[i];
    return factor_a + (factor_b - factor_a) * (facet_in_radii - size_a) / (size_b - size_a);
}

}  // namespace

AttemptSizes attempt_sizes(double facet_in_radii, double cell_in_radii, double scale) {
    const bool finer =
        std::min(facet_in_radii, cell_in_radii) * attempt_scales.back() >= finest_in_radii;
    const auto sized = [&](double size) {
        return std::clamp(finer ? size * scale : size / scale, finest_in_radii, coarsest_in_radii);
    };
    const double facet = sized(facet_in_radii);
    return {facet, sized(cell_in_radii), radius_factor(facet)};
}

}  // namespace hepatica
