// SPDX-License-Identifier: GPL-3.0-or-later
// Constants against each other and against published values (NIST SP 811, appendix B.8).
#include "core/base/units.h"

#include <gtest/gtest.h>

#include "core/base/frame_time.h"

namespace hepatica {
namespace {

TEST(Units, AreThoseOfTheMillimetreGramAndSecond) {
    constexpr double mm_per_m = 1e3, g_per_kg = 1e3;
    EXPECT_DOUBLE_EQ(units::kilogram_per_cubic_metre, g_per_kg / (mm_per_m * mm_per_m * mm_per_m));
    EXPECT_DOUBLE_EQ(units::newton, g_per_kg * mm_per_m);
    EXPECT_DOUBLE_EQ(units::millilitre, 1e-6 * mm_per_m * mm_per_m * mm_per_m);
    EXPECT_DOUBLE_EQ(units::millilitre_per_minute * 60.0, units::millilitre);
    EXPECT_DOUBLE_EQ(units::standard_gravity, 9.80665 * mm_per_m);
}

// A column of mercury of 13.5951 g/cm3 under standard gravity.
TEST(Units, AMillimetreOfMercuryIsTheWeightOfItsColumn) {
    const double density = 13595.1 * units::kilogram_per_cubic_metre;
    EXPECT_NEAR(units::millimetre_of_mercury, density * units::standard_gravity, 1e-6);
}

TEST(Units, SixtyFramesAreASecond) {
    EXPECT_DOUBLE_EQ(60.0 * frame_s, 1.0);
}

}  // namespace
}  // namespace hepatica
