// SPDX-License-Identifier: GPL-3.0-or-later
// The buttons, keys and sliders of the play: each sends what it says, and shows what the newest
// frame says, whoever changed it.
#include <QCheckBox>
#include <QPushButton>
#include <QSlider>
#include <QStatusBar>
#include <QStyle>
#include <QStyleOptionSlider>

#include "tests/ui/fake_window_test.h"
#include "ui/message_bar.h"

namespace hepatica {
namespace {

class PlayControls : public testing::FakeWindowTest {
  protected:
    PlayControls() { open_built_in(); }

    QAction& action(ActionId id) { return window_.actions()[id]; }
    QAction& hold() { return action(ActionId::pause_simulation); }
    QPushButton& play() { return *window_.findChild<QPushButton*>("play"); }
    QSlider& time() { return *window_.findChild<QSlider*>("drugTime"); }
    const DrugView& drug() { return window_.frame().drug; }

    void inject() {
        action(ActionId::inject_mode).trigger();
        QTest::mouseClick(&window_.view(), Qt::LeftButton, {}, on_trunk());
        paint();
    }
    // What Qt sends for one double click of a person.
    void double_click(Qt::KeyboardModifiers keys = {}) {
        QWidget* view = &window_.view();
        QTest::mousePress(view, Qt::LeftButton, keys, on_trunk());
        QTest::mouseRelease(view, Qt::LeftButton, keys, on_trunk());
        QTest::mouseDClick(view, Qt::LeftButton, keys, on_trunk());
        QTest::mouseRelease(view, Qt::LeftButton, keys, on_trunk());
    }
};

TEST_F(PlayControls, hold_and_go_on_follow_the_frame) {
    QTest::keyClick(&window_, Qt::Key_H);
    ASSERT_EQ(commands_of_type<SetPaused>().size(), 1u);
    EXPECT_TRUE(commands_of_type<SetPaused>()[0].paused);
    EXPECT_FALSE(hold().isChecked()) << "no frame says so yet";
    paint();
    EXPECT_TRUE(hold().isChecked());
    QTest::keyClick(&window_, Qt::Key_H);
    ASSERT_EQ(commands_of_type<SetPaused>().size(), 2u);
    EXPECT_FALSE(commands_of_type<SetPaused>()[1].paused);
    paint();
    EXPECT_FALSE(hold().isChecked());
}

TEST_F(PlayControls, reset_ends_pull_drug_and_hold) {
    inject();
    hold().trigger();
    paint();
    ASSERT_TRUE(hold().isChecked());
    QTest::keyClick(&window_, Qt::Key_Backspace);
    EXPECT_EQ(commands_of_type<ResetWorld>().size(), 1u);
    paint();
    EXPECT_FALSE(hold().isChecked());
    EXPECT_FALSE(play().isEnabled());
    hold().trigger();  // one press holds, as the unchecked button promises
    EXPECT_TRUE(commands_of_type<SetPaused>().back().paused);
}

TEST_F(PlayControls, after_a_divergence_hold_is_on_and_one_press_goes_on) {
    simulation_->diverge();
    paint();
    EXPECT_TRUE(hold().isChecked());
    wait_for_figures();
    EXPECT_TRUE(window_.messages().text().contains("diverged"));
    hold().trigger();
    ASSERT_EQ(commands_of_type<SetPaused>().size(), 1u);
    EXPECT_FALSE(commands_of_type<SetPaused>()[0].paused);
    wait_for_figures();
    EXPECT_FALSE(hold().isChecked());
    EXPECT_EQ(window_.messages().text(), "") << "it is no longer so";
}

TEST_F(PlayControls, the_last_good_state_is_offered_and_can_be_restored) {
    simulation_->diverge();
    wait_for_figures();
    QTest::mouseClick(window_.messages().findChild<QPushButton*>("offer"), Qt::LeftButton);
    EXPECT_EQ(commands_of_type<RestoreSnapshot>().size(), 1u);
    paint();
    EXPECT_FALSE(hold().isChecked());
    EXPECT_FALSE(action(ActionId::restore).isEnabled());
    simulation_->diverge();
    paint();
    EXPECT_TRUE(action(ActionId::restore).isEnabled());
    QTest::keyClick(&window_, Qt::Key_Backspace, Qt::ControlModifier);
    EXPECT_EQ(commands_of_type<RestoreSnapshot>().size(), 2u);
}

TEST_F(PlayControls, the_play_button_follows_the_frame) {
    EXPECT_FALSE(play().isEnabled());
    inject();
    EXPECT_TRUE(play().isEnabled());
    EXPECT_EQ(play().text(), "Pause");
    simulation_->post(PlayDrug{false});  // as a replay or a script might
    paint();
    EXPECT_EQ(play().text(), "Play");
    play().click();
    EXPECT_TRUE(commands_of_type<PlayDrug>().back().playing);
    paint();
    EXPECT_EQ(play().text(), "Pause");
}

TEST_F(PlayControls, removing_the_drug_takes_its_clock_away) {
    inject();
    QTest::keyClick(&window_, Qt::Key_Delete);
    EXPECT_EQ(commands_of_type<RemoveDrug>().size(), 1u);
    paint();
    EXPECT_FALSE(play().isEnabled());
    EXPECT_FALSE(time().isEnabled());
    QTest::keyClick(&window_, Qt::Key_Space);
    EXPECT_TRUE(commands_of_type<PlayDrug>().empty());
}

TEST_F(PlayControls, of_a_second_injection_it_is_said_that_it_replaces_the_first) {
    inject();
    EXPECT_FALSE(window_.statusBar()->currentMessage().contains("takes the place"));
    inject();
    EXPECT_TRUE(window_.statusBar()->currentMessage().contains("takes the place of the last one"));
}

TEST_F(PlayControls, space_runs_the_drug_unless_a_button_has_the_focus) {
    inject();
    QTest::keyClick(&window_.view(), Qt::Key_Space);
    ASSERT_EQ(commands_of_type<PlayDrug>().size(), 1u);
    EXPECT_FALSE(commands_of_type<PlayDrug>()[0].playing);

    auto* gravity = window_.findChild<QCheckBox*>("gravity");
    gravity->setFocus();
    ASSERT_EQ(window_.focusWidget(), gravity);
    QTest::keyClick(gravity, Qt::Key_Space);
    EXPECT_TRUE(gravity->isChecked());
    EXPECT_EQ(commands_of_type<PlayDrug>().size(), 1u) << "Space was taken from the check box";

    time().setFocus();  // a slider has no use for it
    QTest::keyClick(&time(), Qt::Key_Space);
    EXPECT_EQ(commands_of_type<PlayDrug>().size(), 2u);
}

TEST_F(PlayControls, keys_move_the_time_slider) {
    inject();
    const auto asked = [this] { return commands_of_type<SetDrugTime>(); };
    time().setFocus();
    QTest::keyClick(&time(), Qt::Key_End);
    ASSERT_EQ(asked().size(), 1u);
    EXPECT_FALSE(commands_of_type<PlayDrug>().back().playing);
    EXPECT_DOUBLE_EQ(asked()[0].time_s, drug().end_s);
    QTest::keyClick(&time(), Qt::Key_Left);
    ASSERT_EQ(asked().size(), 2u);
    EXPECT_NEAR(asked()[1].time_s, 0.99 * drug().end_s, 1e-9);
    QTest::keyClick(&time(), Qt::Key_PageDown);
    EXPECT_NEAR(asked().back().time_s, 0.89 * drug().end_s, 1e-9);
    paint();
    EXPECT_NEAR(drug().time_s, 0.89 * drug().end_s, 1e-9);
    EXPECT_EQ(time().value(), 890);
    EXPECT_EQ(play().text(), "Play");
    QTest::keyClick(&time(), Qt::Key_Home);
    EXPECT_EQ(asked().back().time_s, 0.0);
}

TEST_F(PlayControls, a_click_on_the_time_slider_jumps_there) {
    inject();
    simulation_->post(PlayDrug{false});
    paint();
    const QPoint three_quarters(3 * time().width() / 4, time().height() / 2);
    QTest::mouseClick(&time(), Qt::LeftButton, {}, three_quarters);
    ASSERT_FALSE(commands_of_type<SetDrugTime>().empty());
    EXPECT_NEAR(commands_of_type<SetDrugTime>().back().time_s / drug().end_s, 0.75, 0.03);
    paint();
    EXPECT_NEAR(drug().time_s / drug().end_s, 0.75, 0.03);
}

TEST_F(PlayControls, a_drug_that_has_arrived_starts_again) {
    inject();
    simulation_->post(SetDrugTime{1.5 * drug().end_s});
    simulation_->post(PlayDrug{false});
    paint();
    play().click();
    EXPECT_EQ(commands_of_type<SetDrugTime>().back().time_s, 0.0);
    EXPECT_TRUE(commands_of_type<PlayDrug>().back().playing);
}

TEST_F(PlayControls, a_double_click_injects_once_in_every_mode) {
    std::size_t injections = 0;
    for (const ActionId mode : {ActionId::pull_mode, ActionId::inject_mode}) {
        action(mode).trigger();
        for (const Qt::KeyboardModifiers keys : {Qt::KeyboardModifiers{}, {Qt::ControlModifier}}) {
            double_click(keys);
            EXPECT_EQ(commands_of_type<InjectDrug>().size(), ++injections)
                << "mode " << static_cast<int>(mode) << ", keys " << keys;
        }
    }
    // Two clicks that are no double click inject twice.
    QTest::mouseClick(&window_.view(), Qt::LeftButton, {}, on_trunk());
    QTest::mouseClick(&window_.view(), Qt::LeftButton, {}, on_trunk());
    EXPECT_EQ(commands_of_type<InjectDrug>().size(), injections + 2);
    EXPECT_EQ(commands_of_type<GrabPoint>().size(), commands_of_type<ReleaseGrab>().size());
}

}  // namespace
}  // namespace hepatica
