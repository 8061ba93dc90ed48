// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/drug_leak.h"

#include <gtest/gtest.h>

#include <limits>
#include <memory>

#include "core/flow/injection.h"

namespace hepatica {
namespace {

constexpr float never_s = std::numeric_limits<float>::infinity();

DrugView drug_at(double time_s) {
    DrugView drug;
    drug.arrival_s = std::make_shared<const std::vector<float>>(3, 1.0F);
    InjectionOptions injection;
    injection.mass_flow_g_s = 2.0;
    drug.injection = std::make_shared<const InjectionOptions>(injection);
    drug.time_s = time_s;
    drug.playing = true;
    return drug;
}

TEST(DrugLeak, BeginsAtEachStumpWhereTheDrugArrives) {
    const std::vector<float> leaking{1.0F, 4.0F, never_s};
    const std::vector<double> leaks{0.25, 0.75, 0.5};
    EXPECT_EQ(drug_leak(drug_at(0.5), leaking, leaks).total_g_s, 0.0);
    const DrugLeak first = drug_leak(drug_at(2.0), leaking, leaks);
    EXPECT_EQ(first.total_g_s, 0.25);
    EXPECT_EQ(first.shares, (std::vector<double>{1.0, 0.0, 0.0}));
    const DrugLeak both = drug_leak(drug_at(5.0), leaking, leaks);
    EXPECT_EQ(both.total_g_s, 1.0);
    EXPECT_EQ(both.shares, (std::vector<double>{0.25, 0.75, 0.0}));
}

TEST(DrugLeak, IsNoMoreThanWhatIsInjectedAndStopsWithTheClock) {
    DrugView drug = drug_at(5.0);
    EXPECT_EQ(drug_leak(drug, {1.0F, 4.0F}, {3.0, 9.0}).total_g_s, 2.0);
    drug.speed = 0.5;
    EXPECT_EQ(drug_leak(drug, {1.0F, 4.0F}, {3.0, 9.0}).total_g_s, 1.0);
    drug.playing = false;
    const DrugLeak stopped = drug_leak(drug, {1.0F, 4.0F}, {3.0, 9.0});
    EXPECT_EQ(stopped.total_g_s, 0.0);
    EXPECT_EQ(stopped.shares, (std::vector<double>{0.25, 0.75})) << "what leaked stays there";
}

TEST(DrugLeak, NeedsADrug) {
    EXPECT_TRUE(drug_leak({}, {0.0F}, {1.0}).shares.empty());
}

}  // namespace
}  // namespace hepatica
