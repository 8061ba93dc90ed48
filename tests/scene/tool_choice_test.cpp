// SPDX-License-Identifier: GPL-3.0-or-later
// The shapes of tools as their headers promise them: where tips, jaws and feet are, how far jaws
// open.
#include "core/scene/tools/tool_choice.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/error.h"

namespace hepatica {
namespace {

constexpr double modulus_pa = 4e5, hand_pa = 2e4;
const Vec3 point(3, -4, 5);

ToolChoice choice_of(const std::string& kind) {
    return {.kind = kind,
            .radius_mm = 1.5,
            .length_mm = 12.0,
            .direction = Vec3(0, 3, 4),
            .side = Vec3(2, 0, 1)};
}

Tool made(const std::string& kind) {
    return tool_of(choice_of(kind), point, modulus_pa, hand_pa);
}

const Vec3 ahead = Vec3(0, 3, 4) / 5.0;
const Vec3 aside = (Vec3(2, 0, 1) - Vec3(2, 0, 1).dot(ahead) * ahead).normalized();

TEST(ToolChoice, ASphereAndACapsuleTouchThePointWithTheirTip) {
    const Tool sphere = made("sphere"), capsule = made("capsule");
    ASSERT_EQ(sphere.parts.size(), 1u);
    EXPECT_TRUE(sphere.parts[0].shape.half_axis_mm.isZero(0.0));
    EXPECT_LT((sphere.parts[0].shape.centre_mm - (point - 1.5 * ahead)).norm(), 1e-12);
    ASSERT_EQ(capsule.parts.size(), 1u);
    const Capsule& shape = capsule.parts[0].shape;
    EXPECT_LT((shape.centre_mm + shape.half_axis_mm + 1.5 * ahead - point).norm(), 1e-12);
    EXPECT_NEAR(2.0 * shape.half_axis_mm.norm(), 12.0, 1e-12);
    EXPECT_EQ(widest_opening_mm(capsule), 0.0);
}

TEST(ToolChoice, JawsOfForcepsAreOpenAboutThePointNearTheirTips) {
    const Tool forceps = made("forceps");
    ASSERT_EQ(forceps.parts.size(), 2u);
    const Capsule& one = forceps.parts[0].shape;
    const Capsule& other = forceps.parts[1].shape;
    EXPECT_NEAR(forceps.opening_mm, 6.0 * 1.5, 1e-12);
    EXPECT_EQ(forceps.opening_mm, forceps.opening_target_mm);
    EXPECT_EQ(forceps.opening_mm, widest_opening_mm(forceps));
    const Vec3 between = other.centre_mm - one.centre_mm;
    EXPECT_NEAR(between.norm() - one.radius_mm - other.radius_mm, forceps.opening_mm, 1e-12)
        << "from surface to surface";
    EXPECT_LT((between.normalized() - aside).norm(), 1e-12);
    for (const Capsule& jaw : {one, other})
        EXPECT_LT((jaw.half_axis_mm - 6.0 * ahead).norm(), 1e-12);
    const Vec3 middle = 0.5 * (one.centre_mm + other.centre_mm);
    EXPECT_LT((middle + 3.0 * ahead - point).norm(), 1e-12) << "a quarter behind the tips";
    // Closing moves each jaw by half of the way.
    EXPECT_LT((forceps.parts[1].opens - 0.5 * aside).norm(), 1e-12);
    EXPECT_LT((forceps.parts[0].opens + 0.5 * aside).norm(), 1e-12);
}

TEST(ToolChoice, AHookBendsAtThePointToItsSide) {
    const Tool hook = made("hook");
    ASSERT_EQ(hook.parts.size(), 2u);
    const Capsule& shaft = hook.parts[0].shape;
    const Capsule& foot = hook.parts[1].shape;
    const Vec3 bend = point - 1.5 * ahead;
    EXPECT_LT((shaft.centre_mm + shaft.half_axis_mm - bend).norm(), 1e-12);
    EXPECT_LT((shaft.half_axis_mm - 6.0 * ahead).norm(), 1e-12);
    EXPECT_LT((foot.centre_mm - foot.half_axis_mm - bend).norm(), 1e-12);
    EXPECT_LT((foot.half_axis_mm - 0.2 * 12.0 * aside).norm(), 1e-12);
}

TEST(ToolChoice, IsAsStrongAsAHandOnAVesselOfItsRadius) {
    for (const char* kind : {"sphere", "capsule", "forceps", "hook"}) {
        const Tool tool = made(kind);
        EXPECT_NEAR(tool.force_limit_un, hand_pa * M_PI * 1.5 * 1.5, 1e-9);
        EXPECT_EQ(tool.pressure_pa, 2.0 * modulus_pa);
        EXPECT_NEAR(tool.pad_mm, std::string_view(kind) == "forceps" ? 0.225 : 0.15, 1e-12);
    }
    ToolChoice wide = choice_of("sphere"), thin = wide;
    wide.radius_mm = 80.0;
    thin.radius_mm = 0.2;
    EXPECT_EQ(tool_of(wide, point, modulus_pa, hand_pa).pad_mm, 0.5);
    EXPECT_EQ(tool_of(thin, point, modulus_pa, hand_pa).pad_mm, 0.1);
}

TEST(ToolChoice, TakesAnySideWhereNoneIsNamed) {
    ToolChoice choice = choice_of("hook");
    choice.side.reset();
    const Tool hook = tool_of(choice, point, modulus_pa, hand_pa);
    EXPECT_NEAR(hook.parts[1].shape.half_axis_mm.dot(ahead), 0.0, 1e-12);
    EXPECT_NEAR(hook.parts[1].shape.half_axis_mm.norm(), 2.4, 1e-12);
}

TEST(ToolChoice, RefusesWhatIsNoTool) {
    using Change = void (*)(ToolChoice&);
    for (const Change change : {Change([](ToolChoice& c) { c.kind = "scalpel"; }),
                                Change([](ToolChoice& c) { c.radius_mm = 0.09; }),
                                Change([](ToolChoice& c) { c.radius_mm = 101.0; }),
                                Change([](ToolChoice& c) { c.length_mm = -1.0; }),
                                Change([](ToolChoice& c) { c.length_mm = 1001.0; }),
                                Change([](ToolChoice& c) { c.direction = Vec3::Zero(); }),
                                Change([](ToolChoice& c) { c.side = 7.0 * c.direction; })}) {
        ToolChoice choice = choice_of("forceps");
        change(choice);
        EXPECT_THROW(tool_of(choice, point, modulus_pa, hand_pa), InputError);
    }
    EXPECT_THROW(tool_of(choice_of("hook"), Vec3(NAN, 0, 0), modulus_pa, hand_pa), InputError);
    for (const double radius : {0.1, 100.0}) {
        ToolChoice choice = choice_of("forceps");
        choice.radius_mm = radius;
        EXPECT_NO_THROW(tool_of(choice, point, modulus_pa, hand_pa));
    }
}

}  // namespace
}  // namespace hepatica
