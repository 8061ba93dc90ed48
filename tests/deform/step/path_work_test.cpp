// SPDX-License-Identifier: GPL-3.0-or-later
// Work along a path against energies, whose differences it must be: of weight, of springs and of
// elements.
#include "core/deform/step/path_work.h"

#include <gtest/gtest.h>

#include "tests/deform/support/random_field.h"
#include "tests/deform/support/test_bodies.h"

namespace hepatica {
namespace {

constexpr int of_a_smooth_path = 5;  // evaluations

class OnPath : public testing::Test {
  protected:
    double elastic_nj(std::span<const Vec3> positions_mm) const {
        return assembly_.energy(positions_mm);
    }
    std::vector<Vec3> moved(double size_mm) const {
        std::vector<Vec3> x = body_.rest_positions_mm;
        const auto field = test::random_field(x.size(), size_mm, 3);
        for (std::size_t i = 0; i < x.size(); ++i)
            if (!body_.fixed[i]) x[i] += field[i];
        return x;
    }

    Body body_ = build_body(test::description_of(test::make_bar(12.0, 3.0, 8, 2)),
                            ElementModel::corotated, ElementOrder::linear);
    Assembly assembly_{body_};
    PotentialList potentials_{body_};
    PathWork work_{assembly_};
};

TEST_F(OnPath, NoMotionIsNoWorkAndNeedsNoRefinement) {
    potentials_.set_gravity(Vec3(0, -9810, 0));
    const auto x = moved(0.1);
    const PathWork::Result found = work_.along(x, x, potentials_, 0.0);
    EXPECT_EQ(found.work_nj, 0.0);
    EXPECT_EQ(found.error_nj, 0.0);
    EXPECT_EQ(found.evaluations, of_a_smooth_path);
}

TEST_F(OnPath, WeightDoesMassTimesHeight) {
    potentials_.set_gravity(Vec3(0, -9810, 0));
    std::vector<Vec3> lifted = body_.rest_positions_mm;
    double mass = 0.0;
    for (std::size_t i = 0; i < lifted.size(); ++i) {
        lifted[i].y() += 2.5;
        mass += body_.mass_g[i];
    }
    const double weight = 9810.0 * mass;
    const PathWork::Result found =
        work_.along(body_.rest_positions_mm, lifted, potentials_, 1e-9 * weight);
    EXPECT_NEAR(found.work_nj, -2.5 * weight, 1e-9 * weight);
    EXPECT_EQ(found.evaluations, of_a_smooth_path);
}

TEST_F(OnPath, ElementsGiveWhatTheyHadStored) {
    const auto from = moved(0.15), to = moved(-0.25);
    const double given = elastic_nj(from) - elastic_nj(to);
    int coarse = 0;
    for (const double tolerance : {1e-2, 1e-5, 1e-8}) {
        const PathWork::Result found =
            work_.along(from, to, potentials_, tolerance * std::abs(given));
        EXPECT_LE(found.error_nj, tolerance * std::abs(given));
        EXPECT_NEAR(found.work_nj, given, found.error_nj + 1e-12 * std::abs(given));
        if (tolerance == 1e-2) coarse = found.evaluations;
        if (tolerance == 1e-8) {
            EXPECT_GT(found.evaluations, coarse);
        }
    }
    EXPECT_NEAR(work_.along(to, from, potentials_, 1e-8 * std::abs(given)).work_nj, -given,
                1e-7 * std::abs(given));
}

// However fine it shall be, it ends.
TEST_F(OnPath, TheEvaluationsAreBounded) {
    const PathWork::Result found = work_.along(moved(0.15), moved(-0.25), potentials_, 0.0);
    EXPECT_LE(found.evaluations, 257);
    EXPECT_GT(found.evaluations, 250);
}

}  // namespace
}  // namespace hepatica
