// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inject_panel.h"

#include <gtest/gtest.h>

namespace hepatica {
namespace {

// What a script, `play` and `inject` inject where nobody chooses is what the window offers first.
TEST(InjectPanel, BeginsWithTheDefaultInjection) {
    const InjectPanel panel([](const Command&) {});
    const Vec3 at(1.0, 2.0, 3.0);
    const InjectDrug offered = panel.injection_at(at), unchosen{at};
    EXPECT_EQ(offered.point_mm, unchosen.point_mm);
    EXPECT_DOUBLE_EQ(offered.mass_flow_g_s, unchosen.mass_flow_g_s);
    EXPECT_DOUBLE_EQ(offered.void_fraction, unchosen.void_fraction);
    EXPECT_EQ(offered.second_phase, unchosen.second_phase);
    EXPECT_EQ(offered.pressure_model, unchosen.pressure_model);
    EXPECT_FALSE(offered.drug_viscosity_pa_s.has_value());
}

}  // namespace
}  // namespace hepatica
