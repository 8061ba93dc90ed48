// SPDX-License-Identifier: GPL-3.0-or-later
// What the ties of parted joints take for good after a step: never less than nothing.
#include "core/deform/potentials/softening_ties.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace hepatica {
namespace {

const SofteningLaw law{.strength_pa = 1e5, .opening_mm = 1.0};

// Vertices 0 to 2 are the first side's triangle, and 3 is what 0 was one with.
SofteningTie tie(double most_mm) {
    SofteningTie tie{.vertices = {0, 3}, .area_mm2 = 2.0, .most_mm = most_mm};
    tie.triangle = {0, 1, 2};
    return tie;
}

std::vector<Vec3> opened(const Vec3& opening_mm) {
    return {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, opening_mm};
}

std::vector<Vec3> turned(std::vector<Vec3> x, const Eigen::AngleAxisd& turn) {
    for (const int v : {1, 2}) x[v] = turn * x[v];
    return x;
}

// The sides slide across each other; then the triangle turns, so that they are pressed together.
TEST(SofteningTies, ATurnOfTheNormalMakesNoEnergy) {
    SofteningTies ties;
    const std::vector<Vec3> before = opened({0.4, 0, 0.001});
    ties.set(law, {tie(0.5)}, before);
    const std::vector<Vec3> after = turned(before, Eigen::AngleAxisd(-0.5, Vec3::UnitY()));
    const double stored = ties.energy(after, after);
    const double loss = ties.settle(after);
    EXPECT_GE(loss, 0.0);
    EXPECT_NEAR(ties.energy(after, after), stored - loss, 1e-9 * stored);
}

TEST(SofteningTies, WhatIsTakenIsNeverLessThanNothingAndDamageNeverHeals) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    const auto vector = [&] { return Vec3(unit(random), unit(random), unit(random)); };
    int damaged_more = 0;
    for (int trial = 0; trial < 2000; ++trial) {
        SofteningTies ties;
        const std::vector<Vec3> before = opened(0.6 * vector());
        const double most = 0.02 + 0.9 * std::abs(unit(random));
        ties.set(law, {tie(most)}, before);
        std::vector<Vec3> after =
            turned(before, Eigen::AngleAxisd(3.0 * unit(random), vector().normalized()));
        after[3] += 0.1 * vector();
        const double stored = ties.energy(after, after);
        const double loss = ties.settle(after);
        ASSERT_GE(loss, -1e-9 * stored) << trial;
        ASSERT_NEAR(ties.energy(after, after), stored - loss, 1e-9 * stored + 1e-12) << trial;
        ASSERT_GE(ties.all()[0].most_mm, most);
        ASSERT_LE(ties.all()[0].most_mm, law.opening_mm);
        damaged_more += ties.all()[0].most_mm > most ? 1 : 0;
    }
    EXPECT_GT(damaged_more, 100);
}

// Where nothing turns, exactly the energy of fracture is taken.
TEST(SofteningTies, AStraightPullTakesTheAreaUnderTheLaw) {
    SofteningTies ties;
    ties.set(law, {tie(law.peak_mm())}, opened(Vec3::Zero()));
    double taken = 0.0;
    for (int step = 1; step <= 100; ++step) taken += ties.settle(opened({0, 0, 0.011 * step}));
    EXPECT_NEAR(taken, 2.0 * 1e3 * law.fracture_energy_j_m2(), 1e-9 * taken);
}

}  // namespace
}  // namespace hepatica
