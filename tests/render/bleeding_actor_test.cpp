// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/bleeding_actor.h"

#include <gtest/gtest.h>
#include <vtkActor.h>
#include <vtkActorCollection.h>
#include <vtkNew.h>
#include <vtkRenderer.h>

#include <cmath>
#include <numbers>
#include <optional>

namespace hepatica {
namespace {

// The legend says so.
TEST(PoolOfBlood, HasATenthOfTheVolumeThatIsLost) {
    EXPECT_EQ(radius_of_pool_mm(0.0), 0.0);
    constexpr double fifty_millilitres_g = 53.0;
    EXPECT_NEAR(4.0 / 3.0 * std::numbers::pi * std::pow(radius_of_pool_mm(fifty_millilitres_g), 3),
                5000.0, 1e-6);
}

TEST(PoolOfBlood, HasACloudOnlyWhereDrugLeaked) {
    vtkNew<vtkRenderer> renderer;
    BleedingActor pools(*renderer);
    std::optional<TearView> tear(std::in_place);
    tear->leaks = {{Vec3(1, 2, 3), 1.0}};
    tear->leaked_g = 1.0;
    pools.update(tear);
    const auto ball = [&](int i) {
        return vtkActor::SafeDownCast(renderer->GetActors()->GetItemAsObject(i));
    };
    ASSERT_EQ(renderer->GetActors()->GetNumberOfItems(), 2);
    EXPECT_TRUE(ball(0)->GetVisibility());
    EXPECT_FALSE(ball(1)->GetVisibility());
    EXPECT_DOUBLE_EQ(ball(0)->GetScale()[0], radius_of_pool_mm(1.0));
    tear->leaks[0].drug_g = 0.5;
    EXPECT_TRUE(pools.update(tear));
    EXPECT_TRUE(ball(1)->GetVisibility());
    // The drug is part of what is lost.
    EXPECT_DOUBLE_EQ(ball(1)->GetScale()[0], radius_of_pool_mm(1.0));
    EXPECT_EQ(ball(1)->GetPosition()[2], 3.0);
    EXPECT_DOUBLE_EQ(ball(0)->GetScale()[0], radius_of_pool_mm(0.5));
    tear.reset();
    EXPECT_TRUE(pools.update(tear));
    EXPECT_EQ(renderer->GetActors()->GetNumberOfItems(), 0);
}

TEST(PoolOfBlood, IsHiddenAndShownAgain) {
    vtkNew<vtkRenderer> renderer;
    BleedingActor pools(*renderer);
    std::optional<TearView> tear(std::in_place);
    tear->leaks = {{Vec3(1, 2, 3), 1.0}};
    tear->leaked_g = 100.0;
    EXPECT_TRUE(pools.update(tear));
    pools.set_visible(false);
    EXPECT_TRUE(pools.update(tear));
    EXPECT_EQ(renderer->GetActors()->GetNumberOfItems(), 0);
    EXPECT_FALSE(pools.update(tear));
    pools.set_visible(true);
    EXPECT_TRUE(pools.update(tear));
    EXPECT_EQ(renderer->GetActors()->GetNumberOfItems(), 2) << "the pool and its drug";
}

// A window that is left alone with a vessel that bleeds draws what can be seen, not every step.
TEST(PoolOfBlood, IsDrawnAnewWhereItsGrowthIsSeen) {
    vtkNew<vtkRenderer> renderer;
    BleedingActor pools(*renderer);
    std::optional<TearView> tear(std::in_place);
    tear->leaks = {{Vec3(1, 2, 3), 1.0}};
    tear->leaked_g = 100.0;
    EXPECT_TRUE(pools.update(tear));
    EXPECT_FALSE(pools.update(tear)) << "it bleeds no more";
    int drawn = 0;
    constexpr int steps = 600;  // ten seconds of the lesson's cut branch
    for (int i = 0; i < steps; ++i) {
        tear->leaked_g += 4.7 / 60.0;
        drawn += pools.update(tear) ? 1 : 0;
    }
    const double growth_mm = radius_of_pool_mm(147.0) - radius_of_pool_mm(100.0);
    EXPECT_NEAR(drawn, growth_mm / 0.1, 2.0);
    auto* pool = vtkActor::SafeDownCast(renderer->GetActors()->GetItemAsObject(0));
    EXPECT_NEAR(pool->GetScale()[0], radius_of_pool_mm(147.0), 0.1);
    tear->leaks[0].at_mm.x() += 0.5;
    EXPECT_TRUE(pools.update(tear)) << "the stump moves";
    EXPECT_EQ(pool->GetPosition()[0], 1.5);
    tear->leaks.clear();
    EXPECT_TRUE(pools.update(tear));
    EXPECT_FALSE(pools.update(tear));
}

}  // namespace
}  // namespace hepatica
