// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/flow/fluid.h"

#include <gtest/gtest.h>

#include <limits>

#include "core/base/error.h"

namespace hepatica {
namespace {

TEST(Fluid, MixesByTheTwoRulesOfThePaper) {
    const Fluid fluid = mixture(blood(), gas(), 0.4);
    // (2): 1060 * 0.6 + 1.2 * 0.4 kg/m3; (9): 0.6 * 3.5 + 0.4 * 0.018 mPa s.
    EXPECT_DOUBLE_EQ(fluid.density_g_mm3, 636.48e-6);
    EXPECT_DOUBLE_EQ(fluid.viscosity_pa_s, 2.1072e-3);
    EXPECT_EQ(fluid.void_fraction, 0.4);
}

TEST(Fluid, WithoutASecondPhaseIsTheLiquid) {
    EXPECT_EQ(mixture(blood(), gas(), 0.0), pure(blood()));
}

TEST(Fluid, BlendRunsFromOneFluidToTheOther) {
    const Fluid a = pure(blood());
    const Fluid b = mixture(blood(), lipiodol(), 0.5);
    EXPECT_EQ(blend(a, b, 0.0), a);
    EXPECT_EQ(blend(a, b, 1.0), b);
    // Half of a half: the mixture of a quarter.
    const Fluid half = blend(a, b, 0.5);
    const Fluid quarter = mixture(blood(), lipiodol(), 0.25);
    EXPECT_NEAR(half.density_g_mm3, quarter.density_g_mm3, 1e-18);
    EXPECT_NEAR(half.viscosity_pa_s, quarter.viscosity_pa_s, 1e-17);
}

TEST(Fluid, PresetsNameTheirSources) {
    for (const Phase& phase : second_phases()) {
        EXPECT_FALSE(phase.source.empty());
        EXPECT_EQ(second_phase(phase.name).density_g_mm3, phase.density_g_mm3);
        EXPECT_NO_THROW(validate(pure(phase)));
    }
    EXPECT_FALSE(blood().source.empty());
    EXPECT_THROW(second_phase("honey"), InputError);
}

TEST(Fluid, RefusesImpossibleProperties) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const double bad : {-0.1, 1.0, 2.0, nan})
        EXPECT_THROW(mixture(blood(), gas(), bad), InputError);
    for (const double bad : {0.0, -1.0, nan}) {
        EXPECT_THROW(mixture({"x", bad, 1e-3, ""}, gas(), 0.1), InputError);
        EXPECT_THROW(mixture(blood(), {"x", 1e-3, bad, ""}, 0.1), InputError);
    }
    EXPECT_NO_THROW(mixture(blood(), gas(), 1e-12));
    EXPECT_NO_THROW(mixture(blood(), gas(), 0.999));
}

TEST(Fluid, SaysSmallNumbersAsTheyAre) {
    const auto refusal_of = [](const Fluid& fluid) -> std::string {
        try {
            validate(fluid);
        } catch (const InputError& error) {
            return error.problem();
        }
        return "";
    };
    EXPECT_EQ(refusal_of({1e-12, 3.5e-3, 0.0}), "the density is 1e-12");
    EXPECT_EQ(refusal_of({1e-3, 1e-10, 0.0}), "the viscosity is 1e-10");
    EXPECT_EQ(refusal_of({1e-3, 3.5e-3, -1e-9}), "the void fraction is -1e-09");
}

}  // namespace
}  // namespace hepatica
