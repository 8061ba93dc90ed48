// SPDX-License-Identifier: GPL-3.0-or-later
// Figures of thinning as it is today: branches, plates, balls, rings and cavities drawn by chance,
// thinned in every way and made one voxel wide.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "core/skeleton/padded_object.h"
#include "core/skeleton/thinning.h"
#include "core/skeleton/topology.h"
#include "core/skeleton/unit_width_skeleton.h"
#include "tests/support/recorded_figures.h"

namespace hepatica {
namespace {

Mask drawn_by_chance(unsigned seed) {
    std::mt19937 chance(seed);
    const auto in = [&](double low, double high) {
        return low + (high - low) * static_cast<double>(chance()) / 4294967295.0;
    };
    Grid grid;
    grid.dims = {48, 44, 40};
    grid.spacing_mm = Vec3(0.8, 0.9, 1.3);
    Mask mask(grid);
    for (int tube = 0; tube < 14; ++tube) {
        const Vec3 a(in(4, 44), in(4, 40), in(4, 36)), b(in(4, 44), in(4, 40), in(4, 36));
        const double radius = in(0.6, 3.5);
        for (std::size_t i = 0; i < mask.voxels.size(); ++i) {
            const auto [x, y, z] = grid.index_of(i);
            const Vec3 p(x, y, z);
            const double share = std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
            if ((p - a - share * (b - a)).norm() < radius) mask.voxels[i] = 1;
        }
    }
    // A plate with a hole, and a cavity in a ball.
    for (int x = 20; x < 36; ++x)
        for (int y = 10; y < 30; ++y)
            if (x < 25 || x > 29 || y < 16 || y > 20) mask.at(x, y, 20) = 1;
    for (std::size_t i = 0; i < mask.voxels.size(); ++i) {
        const auto [x, y, z] = grid.index_of(i);
        const double distance = Vec3(x - 10, y - 32, z - 10).norm();
        if (distance < 6.5) mask.voxels[i] = distance > 2.2;
    }
    return mask;
}

TEST(SkeletonFigures, OfThinning) {
    test::Figures figures;
    Job job;
    for (const unsigned seed : {1u, 2u, 3u}) {
        const Mask mask = drawn_by_chance(seed);
        for (const auto& [name, method] : {std::pair{"queue", ThinningMethod::queue},
                                           std::pair{"templates", ThinningMethod::parallel}}) {
            const Mask thinned = thin(mask, method, job);
            const std::string key = std::string(name) + std::to_string(seed);
            const Mask unit = unit_width(thinned, job);
            figures.add(key + ".thin", thinned.voxels).add(key + ".unit", unit.voxels);
            figures.add(key + ".crowded", static_cast<double>(crowded_point_count(thinned)));
            figures.add(key + ".crowded_unit", static_cast<double>(crowded_point_count(unit)));
        }
    }
    test::expect_recorded("skeleton", "thinning", figures);
}

}  // namespace
}  // namespace hepatica
