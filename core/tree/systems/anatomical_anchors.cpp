// SPDX-License-Identifier: GPL-3.0-or-later
// Alternates weights of pieces and weighted means of their positions.
#include "core/tree/systems/anatomical_anchors.h"

#include <array>
#include <cmath>

namespace hepatica {

AnatomicalAnchors find_anchors(const std::vector<VesselPiece>& pieces,
                               const Eigen::AlignedBox3d& liver_mm) {
    const Vec3 expected_hilum(0.47, 0.40, 0.47);  // in shares, as the confluence
    constexpr double spread = 0.12;               // spread of those shares among people
    constexpr double reach_mm = 30.0;             // distance of great vessels from an anchor
    constexpr double prior_weight = 0.25;         // weight of the expected position relative to all
                                                  // vessels there
    constexpr double least_radius_mm = 1.5, most_radius_mm = 6.0;
    constexpr int rounds = 3;
    const Vec3 size = liver_mm.sizes();
    const std::array<Vec3, 2> expected{liver_mm.min() + expected_hilum.cwiseProduct(size),
                                       liver_mm.min() + usual_confluence.cwiseProduct(size)};
    std::array<Vec3, 2> found = expected;
    for (int round = 0; round < rounds; ++round) {
        std::array<Vec3, 2> sum{Vec3::Zero(), Vec3::Zero()};
        std::array<double, 2> weight{0.0, 0.0};
        for (const VesselPiece& piece : pieces) {
            if (piece.radius_mm <= least_radius_mm) continue;
            std::array<double, 2> likelihood{};
            for (int k = 0; k < 2; ++k) {
                const Vec3 share = (piece.centre_mm - expected[k]).cwiseQuotient(spread * size);
                const double away = (piece.centre_mm - found[k]).norm() / reach_mm;
                likelihood[k] = std::exp(-0.5 * (share.squaredNorm() + away * away));
            }
            const int k = likelihood[1] > likelihood[0] ? 1 : 0;
            const double radius = std::min(piece.radius_mm, most_radius_mm);
            const double w = piece.length_mm * radius * radius * likelihood[k];
            sum[k] += w * piece.centre_mm;
            weight[k] += w;
        }
        for (int k = 0; k < 2; ++k)
            if (weight[k] > 0.0)
                found[k] = (sum[k] / weight[k] + prior_weight * expected[k]) / (1.0 + prior_weight);
    }
    return {found[0], found[1]};
}

}  // namespace hepatica
