// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tear/softening.h"

#include <gtest/gtest.h>

#include <random>

namespace hepatica {
namespace {

const SofteningLaw law{.strength_pa = 2e5, .opening_mm = 0.4};

double traction_pa(double opening, double most_mm) {
    return law.secant_pa_mm(opening, most_mm) * opening;
}

TEST(Softening, TheAreaUnderItIsTheFractureEnergy) {
    double area = 0.0;
    constexpr int steps = 400000;
    for (int i = 0; i < steps; ++i)
        area += traction_pa((i + 0.5) * law.opening_mm / steps, 0.0) * law.opening_mm / steps;
    EXPECT_NEAR(1e-3 * area, law.fracture_energy_j_m2(), 1e-6 * law.fracture_energy_j_m2());
    EXPECT_NEAR(law.energy_un_mm(2.0, 0.0), area, 1e-6 * area);
    EXPECT_NEAR(traction_pa(law.peak_mm(), 0.0), law.strength_pa, 1e-9 * law.strength_pa);
    EXPECT_EQ(traction_pa(law.opening_mm, 0.0), 0.0);
}

TEST(Softening, NeverHeals) {
    const double most = 0.2;
    EXPECT_DOUBLE_EQ(traction_pa(0.1, most), 0.5 * traction_pa(most, most));
    EXPECT_LT(law.energy_un_mm(0.1, most), law.energy_un_mm(0.1, 0.0));
    EXPECT_EQ(traction_pa(0.1, law.opening_mm), 0.0);
}

SofteningTie any_tie(std::mt19937& random) {
    std::uniform_real_distribution<double> share(0.0, 1.0);
    std::normal_distribution<double> gauss;
    SofteningTie tie;
    tie.area_mm2 = 0.1 + share(random);
    tie.most_mm = law.peak_mm() + share(random) * (law.opening_mm - law.peak_mm());
    tie.normal = Vec3(gauss(random), gauss(random), gauss(random)).normalized();
    return tie;
}

// Pulled, sheared and pressed, before and behind the widest opening so far.
TEST(SofteningTie, ForceIsTheGradientOfTheEnergy) {
    std::mt19937 random(3);
    std::normal_distribution<double> gauss;
    for (int trial = 0; trial < 300; ++trial) {
        const SofteningTie tie = any_tie(random);
        const Vec3 opening = 0.2 * Vec3(gauss(random), gauss(random), gauss(random));
        const Vec3 force = force_of(law, tie, opening);
        Vec3 slope;
        for (int i = 0; i < 3; ++i) {
            const Vec3 h = 1e-6 * Vec3::Unit(i);
            slope[i] = (energy_of(law, tie, opening + h) - energy_of(law, tie, opening - h)) / 2e-6;
        }
        EXPECT_LT((slope - force).norm(), 1e-5 * law.strength_pa) << trial;
    }
}

TEST(SofteningTie, ItsSecantGivesItsForceAndIsNotNegative) {
    std::mt19937 random(4);
    std::normal_distribution<double> gauss;
    for (int trial = 0; trial < 100; ++trial) {
        const SofteningTie tie = any_tie(random);
        const Vec3 opening = 0.2 * Vec3(gauss(random), gauss(random), gauss(random));
        const Mat3 stiffness = stiffness_of(law, tie, opening);
        EXPECT_LT((stiffness * opening - force_of(law, tie, opening)).norm(),
                  1e-9 * law.strength_pa);
        for (int k = 0; k < 5; ++k) {
            const Vec3 d(gauss(random), gauss(random), gauss(random));
            EXPECT_GE(d.dot(stiffness * d), 0.0);
        }
    }
}

TEST(SofteningTie, PressedTogetherItDoesNotOpenAndKeepsItsStiffness) {
    SofteningTie tie{.area_mm2 = 1.0, .most_mm = 0.3, .normal = Vec3::UnitZ()};
    const Vec3 pressed(0.0, 0.0, -0.1);
    EXPECT_EQ(effective_opening_mm(tie, pressed), 0.0);
    EXPECT_NEAR(force_of(law, tie, pressed).z(), -law.strength_pa / law.peak_mm() * 0.1, 1e-6);
    tie.most_mm = law.opening_mm;  // come apart
    EXPECT_EQ(energy_of(law, tie, pressed), 0.0);
    EXPECT_EQ(force_of(law, tie, pressed), Vec3(Vec3::Zero()));
}

}  // namespace
}  // namespace hepatica
