// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tool_panel.h"

#include <gtest/gtest.h>

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QLabel>

#include "tests/ui/fake_window_test.h"

namespace hepatica {
namespace {

TEST(ToolPanel, says_how_hard_the_hand_pulls_and_when_it_pulls_no_harder) {
    ToolPanel panel({});
    const auto* force = panel.findChild<QLabel*>("toolForce");
    GrabView hand{Vec3::Zero(), Vec3(5, 0, 0), 12.4e3, false};
    panel.show_force(std::nullopt, hand);
    EXPECT_EQ(force->text(), "Pull 12 mN");
    hand.at_limit = true;
    panel.show_force(std::nullopt, hand);
    EXPECT_EQ(force->text(), "Pull 12 mN, the most it has");
    hand.felt_un = 5.2e3;  // it is what a lesson judges
    panel.show_force(std::nullopt, hand);
    EXPECT_EQ(force->text(), "Pull 5.2 mN, the most it has");
    panel.show_force(ToolView{}, hand);
    EXPECT_EQ(force->text(), "touches nothing");
    ToolView tool;
    tool.force_un = Vec3(0, 1571e3, 0);
    tool.felt_un = 590e3;
    panel.show_force(tool, std::nullopt);
    EXPECT_EQ(force->text(), "Force 590 mN");
    panel.show_force(std::nullopt, std::nullopt);
    EXPECT_EQ(force->text(), "no tool");
}

// Obstacles take seconds to be made: until a frame has them, what was chosen stays chosen.
TEST(ToolPanel, keeps_what_the_vessels_shall_touch_until_it_is_heard) {
    std::vector<UseContact> asked;
    ToolPanel::Callbacks callbacks;
    callbacks.use_contact = [&](const UseContact& contact) { asked.push_back(contact); };
    ToolPanel panel(std::move(callbacks));
    auto& each_other = *panel.findChild<QCheckBox*>("vesselsTouch");
    auto& obstacles = *panel.findChild<QCheckBox*>("obstaclesTouch");
    auto& friction = *panel.findChild<QDoubleSpinBox*>("vesselFriction");
    Frame frame;
    frame.step = 7;
    panel.show_contact(frame);
    EXPECT_FALSE(friction.isEnabled());
    each_other.click();
    friction.setValue(0.3);
    obstacles.click();
    ASSERT_EQ(asked.size(), 3u);
    EXPECT_TRUE(asked.back().self && asked.back().obstacles);
    EXPECT_EQ(asked.back().friction, 0.3);
    frame.step = 8;  // was under way
    panel.show_contact(frame);
    EXPECT_TRUE(each_other.isChecked() && obstacles.isChecked());
    frame.step = 9;
    frame.self_friction = 0.3;  // and the case knows no obstacles
    panel.show_contact(frame);
    EXPECT_TRUE(each_other.isChecked());
    EXPECT_FALSE(obstacles.isChecked());
    EXPECT_TRUE(friction.isEnabled());
    panel.begin_play(false);
    EXPECT_EQ(asked.size(), 3u) << "a lesson says itself what is touched";
    panel.begin_play(true);
    ASSERT_EQ(asked.size(), 4u);
    EXPECT_EQ(asked.back().friction, 0.3);
    panel.allow_settings(false);
    EXPECT_FALSE(each_other.isEnabled());
    panel.show_contact(frame);
    EXPECT_FALSE(friction.isEnabled());
}

// The boxes are off at every start unless the user had them on; a lesson changes no such wish.
TEST(ToolPanel, begins_with_what_was_touched_in_an_earlier_run) {
    std::vector<UseContact> asked, chosen;
    ToolPanel::Callbacks callbacks;
    callbacks.use_contact = [&](const UseContact& contact) { asked.push_back(contact); };
    callbacks.contact_chosen = [&](const UseContact& contact) { chosen.push_back(contact); };
    ToolPanel panel(std::move(callbacks));
    panel.set_wanted_contact({true, false, 0.1});
    panel.begin_play(false);
    EXPECT_TRUE(asked.empty());
    panel.findChild<QCheckBox*>("obstaclesTouch")->click();  // where the lesson allows it
    EXPECT_TRUE(chosen.empty());
    asked.clear();
    panel.begin_play(true);
    ASSERT_EQ(asked.size(), 1u);
    EXPECT_TRUE(asked[0].self && !asked[0].obstacles);
    EXPECT_EQ(asked[0].friction, 0.1);
    EXPECT_TRUE(chosen.empty());
    panel.findChild<QCheckBox*>("vesselsTouch")->click();
    ASSERT_EQ(chosen.size(), 1u);
}

}  // namespace
}  // namespace hepatica
