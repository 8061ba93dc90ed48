// SPDX-License-Identifier: GPL-3.0-or-later
// A tool in the hand of the mouse: what keys, moves and the wheel send, and what is shown of it.
#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QStatusBar>
#include <QToolBar>
#include <QToolButton>
#include <QWheelEvent>
#include <numbers>

#include "tests/ui/fake_window_test.h"
#include "ui/tool_panel.h"

namespace hepatica {
namespace {

class ToolInHand : public testing::FakeWindowTest {
  protected:
    ToolInHand() { open_built_in(); }

    void point_at(const QPoint& place) {
        QMouseEvent move(QEvent::MouseMove, place, window_.view().mapToGlobal(place), Qt::NoButton,
                         Qt::NoButton, Qt::NoModifier);
        QApplication::sendEvent(&window_.view(), &move);
    }
    void turn_wheel(int notches, Qt::KeyboardModifiers keys = {}) {
        const QPointF place(window_.view().rect().center());
        QWheelEvent wheel(place, window_.view().mapToGlobal(place), {}, QPoint(0, 120 * notches),
                          Qt::NoButton, keys, Qt::NoScrollPhase, false);
        QApplication::sendEvent(&window_.view(), &wheel);
    }
    // A tool over the trunk, as a frame shows it.
    void take(Qt::Key key) {
        QTest::keyClick(&window_, key);
        point_at(on_trunk());
        paint();
        ASSERT_TRUE(window_.frame().tool);
    }
    QAction& action(ActionId id) { return window_.actions()[id]; }
    ViewAxes axes() { return window_.view().scene().axes(); }
    template <class T>
    std::size_t count() const {
        return commands_of_type<T>().size();
    }
};

TEST_F(ToolInHand, comes_where_the_mouse_is_and_once) {
    QTest::keyClick(&window_, Qt::Key_4);
    ASSERT_EQ(count<UseTools>(), 1u);
    EXPECT_TRUE(commands_of_type<UseTools>()[0].on);
    EXPECT_EQ(count<AddTool>(), 0u) << "nobody knows where yet";
    point_at(on_trunk());
    point_at(on_trunk() + QPoint(1, 0));
    ASSERT_EQ(count<AddTool>(), 1u);
    const AddTool tool = commands_of_type<AddTool>()[0];
    EXPECT_EQ(tool.kind, "sphere");
    EXPECT_NEAR(tool.point_mm.z(), half_way_up_the_trunk_mm, 2.0);
    EXPECT_LT((tool.point_mm - Vec3(0, 0, tool.point_mm.z())).norm(), 7.0) << "on the trunk's wall";
    EXPECT_GT(tool.direction.dot(axes().forward), 0.97);
    EXPECT_EQ(count<GrabPoint>(), 0u);
}

TEST_F(ToolInHand, follows_the_mouse_in_the_plane_of_the_picture) {
    take(Qt::Key_4);
    const double depth = window_.frame().tool->tip_mm.dot(axes().forward);
    for (const QPoint by : {QPoint(30, 0), QPoint(30, -40), QPoint(-70, 12)}) {
        point_at(on_trunk() + by);
        const Vec3 target = commands_of_type<MoveTool>().back().target_mm;
        EXPECT_LE((on_widget(target) - on_trunk() - by).manhattanLength(), 2);
        EXPECT_NEAR(target.dot(axes().forward), depth, 1e-9);
        paint();
    }
    EXPECT_EQ(count<AddTool>(), 1u);
}

TEST_F(ToolInHand, of_a_rod_the_mouse_leads_the_tip) {
    take(Qt::Key_5);
    EXPECT_EQ(commands_of_type<AddTool>().back().kind, "capsule");
    EXPECT_EQ(commands_of_type<AddTool>().back().length_mm, 30.0);
    point_at(on_trunk() + QPoint(50, 20));
    paint();
    EXPECT_LE(
        (on_widget(window_.frame().tool->tip_mm) - on_trunk() - QPoint(50, 20)).manhattanLength(),
        2);
}

TEST_F(ToolInHand, the_wheel_moves_it_in_depth_and_control_zooms) {
    take(Qt::Key_4);
    const Vec3 before = window_.frame().tool->tip_mm;
    turn_wheel(3);
    const Vec3 target = commands_of_type<MoveTool>().back().target_mm;
    EXPECT_NEAR((target - before).dot(axes().forward), 3.0, 1e-9);
    const std::size_t moves = count<MoveTool>();
    const Pixel tip = window_.view().scene().pixel_of(Vec3(30, 0, 40));
    turn_wheel(2, Qt::ControlModifier);
    const Pixel zoomed = window_.view().scene().pixel_of(Vec3(30, 0, 40));
    EXPECT_GT(std::hypot(zoomed.x - tip.x, zoomed.y - tip.y), 5.0);
    EXPECT_EQ(count<MoveTool>(), moves);
}

// At once it would strike the vessel and decide a lesson by its force.
TEST_F(ToolInHand, the_depth_of_the_wheel_is_reached_over_a_moment_of_the_play) {
    take(Qt::Key_4);
    const auto over_s = [this] { return commands_of_type<MoveTool>().back().over_s.value_or(0.0); };
    ToolView tool = *window_.frame().tool;
    const Vec3 forward = axes().forward, before = tool.tip_mm;
    turn_wheel(1);
    EXPECT_DOUBLE_EQ(over_s(), wheel_over_s);
    turn_wheel(2);
    EXPECT_DOUBLE_EQ(over_s(), wheel_over_s);
    EXPECT_NEAR((commands_of_type<MoveTool>().back().target_mm - before).dot(forward), 3.0, 1e-9);
    point_at(on_trunk() + QPoint(1, 0));  // the mouse must not hasten it
    EXPECT_NEAR(over_s(), wheel_over_s, 1e-9);
    const auto led_by = [&](double mm) {
        tool.tip_mm += mm * forward;
        tool.centre_mm += mm * forward;
        window_.view().mouse().hand().follow(tool);
    };
    led_by(1.5);
    point_at(on_trunk() + QPoint(2, 0));
    EXPECT_GE(over_s(), 0.5 * wheel_over_s - 1e-9);
    EXPECT_LE(over_s(), HandPace::longest_s);
    led_by(1.5);
    const std::size_t moves = count<MoveTool>();
    paint();
    EXPECT_EQ(count<MoveTool>(), moves) << "nothing is sent again and again";
}

TEST_F(ToolInHand, a_zoom_pulls_no_vessel_at_once) {
    const QPoint place = on_trunk(), mouse = place + QPoint(40, 30);
    QTest::mousePress(&window_.view(), Qt::LeftButton, {}, place);
    ASSERT_EQ(count<GrabPoint>(), 1u);
    QTest::mouseMove(&window_.view(), mouse);
    const std::size_t moves = count<MoveGrab>();
    turn_wheel(1);
    ASSERT_EQ(count<MoveGrab>(), moves + 1);
    const MoveGrab move = commands_of_type<MoveGrab>().back();
    EXPECT_DOUBLE_EQ(move.over_s.value_or(0.0), wheel_over_s);
    EXPECT_LE((on_widget(move.target_mm) - mouse).manhattanLength(), 2);
    QTest::mouseRelease(&window_.view(), Qt::LeftButton, {}, mouse);
    const std::size_t after = count<MoveGrab>();
    turn_wheel(1);
    EXPECT_EQ(count<MoveGrab>(), after);
}

// Taken up over nothing it may be far from the vessel that it is for.
TEST_F(ToolInHand, the_wheel_with_shift_moves_it_five_times_as_far) {
    take(Qt::Key_4);
    const Vec3 before = window_.frame().tool->tip_mm;
    turn_wheel(-2, Qt::ShiftModifier);
    const Vec3 target = commands_of_type<MoveTool>().back().target_mm;
    EXPECT_NEAR((target - before).dot(axes().forward), -10.0, 1e-9);
}

TEST_F(ToolInHand, keys_turn_it_in_the_plane_of_the_picture) {
    take(Qt::Key_5);
    QTest::keyClick(&window_, Qt::Key_T);
    QTest::keyClick(&window_, Qt::Key_T, Qt::ShiftModifier);
    const auto turns = commands_of_type<TurnTool>();
    ASSERT_EQ(turns.size(), 2u);
    // Against the clock, as one sees it.
    const Vec3 turned =
        Eigen::AngleAxisd(turns[0].by_rad.norm(), turns[0].by_rad.normalized()) * axes().right;
    EXPECT_NEAR(turned.dot(axes().up), std::sin(std::numbers::pi / 12.0), 1e-9);
    EXPECT_LT((turns[0].by_rad + turns[1].by_rad).norm(), 1e-12);
}

TEST_F(ToolInHand, forceps_and_hook_come_across_the_picture_and_c_closes_and_opens) {
    for (const auto& [key, kind] : {std::pair{Qt::Key_6, "forceps"}, {Qt::Key_7, "hook"}}) {
        take(key);
        const AddTool tool = commands_of_type<AddTool>().back();
        EXPECT_EQ(tool.kind, kind);
        ASSERT_TRUE(tool.side);
        EXPECT_NEAR(tool.side->dot(axes().forward), 0.0, 1e-9);
        EXPECT_NEAR(tool.side->dot(tool.direction), 0.0, 1e-9);
        EXPECT_GE(tool.side->dot(axes().up), -1e-9);
        // Across the trunk, which runs upwards in the picture.
        EXPECT_NEAR(std::abs(tool.side->dot(axes().right)), 1.0, 1e-6);
        EXPECT_NEAR(tool.direction.dot(axes().forward), 0.8, 1e-6);
        for (int i = 0; i < 3; ++i) QTest::keyClick(&window_, Qt::Key_C);
    }
    EXPECT_EQ(count<CloseForceps>(), 2u) << "a hook has no jaws";
    EXPECT_EQ(count<OpenForceps>(), 1u);
    // Another pair comes open.
    take(Qt::Key_6);
    QTest::keyClick(&window_, Qt::Key_C);
    EXPECT_EQ(count<CloseForceps>(), 3u);
}

TEST_F(ToolInHand, escape_puts_it_away_and_another_mode_too) {
    for (const Qt::Key key : {Qt::Key_Escape, Qt::Key_2, Qt::Key_3, Qt::Key_1}) {
        take(Qt::Key_4);
        QTest::keyClick(&window_, key);
        paint();
        EXPECT_FALSE(window_.frame().tool);
        EXPECT_FALSE(commands_of_type<UseTools>().back().on);
        const std::size_t tools = count<AddTool>(), moves = count<MoveTool>();
        point_at(on_trunk() + QPoint(9, 9));
        EXPECT_EQ(count<AddTool>(), tools);
        EXPECT_EQ(count<MoveTool>(), moves);
    }
    EXPECT_EQ(count<UseTools>(), 8u);
    QTest::keyClick(&window_, Qt::Key_2);
    QTest::keyClick(&window_, Qt::Key_Escape);
    EXPECT_EQ(window_.view().mouse().mode(), MouseMode::inject) << "there was no tool";
}

TEST_F(ToolInHand, another_tool_takes_its_place) {
    take(Qt::Key_4);
    QTest::keyClick(&window_, Qt::Key_5);
    EXPECT_EQ(count<UseTools>(), 1u);
    ASSERT_EQ(count<AddTool>(), 2u);
    EXPECT_EQ(commands_of_type<AddTool>().back().kind, "capsule");
}

TEST_F(ToolInHand, drags_turn_the_view_and_leave_it_where_it_is) {
    take(Qt::Key_4);
    const std::size_t before = simulation_->commands().size();
    const Vec3 forward = axes().forward;
    QTest::mousePress(&window_.view(), Qt::LeftButton, {}, on_trunk());
    QTest::mouseMove(&window_.view(), on_trunk() + QPoint(60, 10));
    QTest::mouseRelease(&window_.view(), Qt::LeftButton, {}, on_trunk() + QPoint(60, 10));
    EXPECT_LT(forward.dot(axes().forward), 0.99);
    EXPECT_EQ(simulation_->commands().size(), before);
    QTest::mouseDClick(&window_.view(), Qt::LeftButton, {}, on_trunk());
    EXPECT_EQ(count<InjectDrug>(), 0u);
}

TEST_F(ToolInHand, a_click_on_a_vessel_brings_it_there_from_another_depth) {
    take(Qt::Key_6);
    const auto click = [this] {
        QTest::mouseClick(&window_.view(), Qt::LeftButton, {}, on_trunk());
        paint();
    };
    click();
    EXPECT_EQ(count<AddTool>(), 1u) << "it is there already";
    const Vec3 tip = window_.frame().tool->tip_mm;
    const Vec3 place = commands_of_type<AddTool>()[0].point_mm;
    for (const int notches : {20, -20}) {
        turn_wheel(notches);
        paint();
        ASSERT_GT((window_.frame().tool->tip_mm - tip).norm(), 15.0);
        const std::size_t tools = count<AddTool>();
        click();
        ASSERT_EQ(count<AddTool>(), tools + 1);
        EXPECT_LT((commands_of_type<AddTool>().back().point_mm - place).norm(), 1e-6);
    }
    turn_wheel(20);
    paint();
    const std::size_t tools = count<AddTool>();
    QTest::mouseClick(&window_.view(), Qt::LeftButton, {}, QPoint(4, 4));
    EXPECT_EQ(count<AddTool>(), tools) << "no vessel there";
    QTest::keyClick(&window_, Qt::Key_C);
    click();
    EXPECT_EQ(count<AddTool>(), tools) << "closed jaws would let go";
}

// As where a lesson asks for the distance of its tip.
TEST_F(ToolInHand, nothing_pointed_at_brings_it_where_it_is_to_be_led) {
    window_.view().mouse().hand().may_bring = [] { return false; };
    take(Qt::Key_4);
    const Vec3 forward = axes().forward;
    EXPECT_NEAR(commands_of_type<AddTool>().back().point_mm.dot(forward),
                axes().focus_mm.dot(forward), 1e-6)
        << "not on the vessel";
    turn_wheel(-20);
    paint();
    QTest::mouseClick(&window_.view(), Qt::LeftButton, {}, on_trunk());
    EXPECT_EQ(count<AddTool>(), 1u);
}

// On a slow computer frames with the tool at its old place come after the click; the mouse leads
// the new one at the depth of the click all the same.
TEST_F(ToolInHand, keeps_the_depth_of_a_click_though_older_frames_follow_it) {
    take(Qt::Key_4);
    turn_wheel(-20);
    paint();
    const ToolView far = *window_.frame().tool;
    QTest::mouseClick(&window_.view(), Qt::LeftButton, {}, on_trunk());
    ASSERT_EQ(count<AddTool>(), 2u);
    ToolHand& hand = window_.view().mouse().hand();
    hand.follow(far);
    hand.follow(far);
    ToolView come = far;
    come.tip_mm = come.centre_mm = commands_of_type<AddTool>().back().point_mm;
    hand.follow(come);
    const double depth = come.tip_mm.dot(axes().forward);
    ASSERT_GT(std::abs(depth - far.tip_mm.dot(axes().forward)), 10.0);
    point_at(on_trunk() + QPoint(2, 0));
    EXPECT_NEAR(commands_of_type<MoveTool>().back().target_mm.dot(axes().forward), depth, 1e-9);
}

TEST_F(ToolInHand, a_click_on_a_mark_of_the_lesson_brings_it_to_its_depth) {
    take(Qt::Key_4);
    SceneView& scene = window_.view().scene();
    const QPoint place(60, 60);
    const Pixel pixel = pixel_at(place, window_.view().devicePixelRatioF());
    ASSERT_LT(scene.pick(pixel).triangle, 0) << "a vessel would be there";
    const Vec3 mark = scene.point_at_depth(pixel, axes().focus_mm + 25.0 * axes().forward);
    scene.set_marks({{mark, ""}});
    QTest::mouseClick(&window_.view(), Qt::LeftButton, {}, place);
    ASSERT_EQ(count<AddTool>(), 2u);
    EXPECT_LT((commands_of_type<AddTool>()[1].point_mm - mark).norm(), 1e-6);
}

TEST_F(ToolInHand, a_click_neither_turns_it_nor_tears_it_off_what_it_touches) {
    take(Qt::Key_5);
    ToolView tool = *window_.frame().tool;
    const Vec3 turned = (tool.parts[0].to_mm - tool.parts[0].from_mm).norm() * axes().right;
    tool.parts[0].to_mm = tool.parts[0].from_mm + turned;
    tool.tip_mm += 20.0 * axes().forward;
    ToolHand& hand = window_.view().mouse().hand();
    const auto click = [&] {
        hand.follow(tool);
        QTest::mouseClick(&window_.view(), Qt::LeftButton, {}, on_trunk());
    };
    tool.touched = {1, 2, 3};
    click();
    EXPECT_EQ(count<AddTool>(), 1u);
    tool.touched.clear();
    click();
    ASSERT_EQ(count<AddTool>(), 2u);
    EXPECT_LT((commands_of_type<AddTool>()[1].direction - axes().right).norm(), 1e-9);
}

TEST_F(ToolInHand, its_radius_is_set_in_the_panel) {
    take(Qt::Key_4);
    const Vec3 tip = window_.frame().tool->tip_mm;
    window_.findChild<QDoubleSpinBox*>("toolRadius")->setValue(4.5);
    ASSERT_EQ(count<AddTool>(), 2u);
    EXPECT_EQ(commands_of_type<AddTool>().back().radius_mm, 4.5);
    EXPECT_EQ(commands_of_type<AddTool>().back().point_mm, tip);
    EXPECT_FALSE(window_.findChild<QDoubleSpinBox*>("toolLength")->isEnabled());
    QTest::keyClick(&window_, Qt::Key_5);
    EXPECT_TRUE(window_.findChild<QDoubleSpinBox*>("toolLength")->isEnabled());
    EXPECT_EQ(commands_of_type<AddTool>().back().radius_mm, 4.5);
}

// Else the key of a tool would be typed into the field.
TEST_F(ToolInHand, its_key_is_heard_after_a_number_was_entered) {
    auto* factor = window_.findChild<QDoubleSpinBox*>("tearFactor");
    factor->setFocus();
    ASSERT_EQ(window_.focusWidget(), factor);
    factor->selectAll();
    QTest::keyClicks(factor, "0.3");
    QTest::keyClick(factor, Qt::Key_Return);
    EXPECT_EQ(factor->value(), 0.3);
    EXPECT_EQ(window_.focusWidget(), &window_.view()) << "which reads the keys that lead a tool";
}

// Whoever has found the depth of a vessel with the probe finds the forceps there.
TEST_F(ToolInHand, another_comes_to_where_the_one_before_was) {
    take(Qt::Key_4);
    turn_wheel(5);
    paint();
    const Vec3 tip = window_.frame().tool->tip_mm;
    QTest::keyClick(&window_, Qt::Key_6);
    ASSERT_EQ(count<AddTool>(), 2u);
    EXPECT_EQ(commands_of_type<AddTool>().back().kind, "forceps");
    EXPECT_LT((commands_of_type<AddTool>().back().point_mm - tip).norm(), 1e-9);
}

// On its way to the depth of the one before it may be stopped far from the mouse, which must then
// not lead it through what is there.
TEST_F(ToolInHand, another_that_is_stopped_on_its_way_comes_to_the_mouse_in_front_of_the_vessels) {
    take(Qt::Key_4);
    const ToolView probe = *window_.frame().tool;
    QTest::keyClick(&window_, Qt::Key_6);
    ASSERT_EQ(count<AddTool>(), 2u);
    const AddTool asked = commands_of_type<AddTool>().back();
    ToolHand& hand = window_.view().mouse().hand();
    const auto forceps_at = [&](const Vec3& place) {
        ToolView forceps;
        const Vec3 along = asked.length_mm * asked.direction.normalized();
        forceps.centre_mm = place - 0.25 * along;
        forceps.tip_mm = place + 0.25 * along;
        for (const double side : {-8.0, 8.0}) {
            const Vec3 end = forceps.tip_mm + side * asked.side->normalized();
            forceps.parts.push_back({end - along, end, asked.radius_mm});
        }
        return forceps;
    };
    hand.follow(probe);  // a frame from before the forceps came
    EXPECT_EQ(count<AddTool>(), 2u);
    const Vec3 stopped_mm = asked.point_mm - 25.0 * asked.direction.normalized();
    hand.follow(forceps_at(stopped_mm));
    ASSERT_EQ(count<AddTool>(), 3u);
    const AddTool again = commands_of_type<AddTool>().back();
    EXPECT_LE((on_widget(again.point_mm) - on_trunk()).manhattanLength(), 2);
    EXPECT_NEAR(again.point_mm.dot(axes().forward), stopped_mm.dot(axes().forward), 1e-6);
    EXPECT_LT((again.direction - asked.direction.normalized()).norm(), 1e-9);
    hand.follow(forceps_at(stopped_mm));  // likewise
    const ToolView come = forceps_at(again.point_mm);
    hand.follow(come);
    EXPECT_EQ(count<AddTool>(), 3u);
    point_at(on_trunk() + QPoint(1, 0));
    const Vec3 led_by = commands_of_type<MoveTool>().back().target_mm - come.centre_mm;
    EXPECT_LT(led_by.norm(), 3.0);
    EXPECT_NEAR(led_by.dot(axes().forward), 0.0, 1e-6) << "not to the depth of the probe";
}

TEST_F(ToolInHand, a_leap_of_the_mouse_leads_it_no_faster_than_a_hand_goes) {
    take(Qt::Key_4);
    const auto led_mm = [this] {
        return (commands_of_type<MoveTool>().back().target_mm - window_.frame().tool->centre_mm)
            .norm();
    };
    const auto over_s = [this] { return commands_of_type<MoveTool>().back().over_s.value_or(0.0); };
    point_at(on_trunk() + QPoint(3, 0));
    ASSERT_LT(led_mm(), usual_lag_mm);
    EXPECT_LE(over_s(), HandPace::longest_s);
    point_at(QPoint(4, 4));
    ASSERT_GT(led_mm(), 2.0 * usual_lag_mm);
    EXPECT_NEAR(over_s(), std::min(longest_move_s, led_mm() / fastest_lead_mm_per_s), 1e-9);
}

TEST_F(ToolInHand, the_panel_says_what_it_feels) {
    auto* force = window_.findChild<QLabel*>("toolForce");
    wait_for_figures();
    EXPECT_EQ(force->text(), "no tool");
    take(Qt::Key_4);
    wait_for_figures();
    EXPECT_EQ(force->text(), "touches nothing");
    point_at(on_trunk() + QPoint(40, 0));
    paint();
    wait_for_figures();
    const double felt_un = window_.frame().tool->shown_un();
    EXPECT_EQ(force->text(), QString("Force %1 mN").arg(1e-3 * felt_un, 0, 'f', 1));
}

TEST_F(ToolInHand, of_the_hand_that_just_misses_a_vessel_is_told) {
    const auto said = [this] { return window_.statusBar()->currentMessage(); };
    const auto click = [this](const QPoint& place) {
        window_.statusBar()->clearMessage();
        QTest::mouseClick(&window_.view(), Qt::LeftButton, {}, place);
    };
    // From the trunk outwards until the first place beside it.
    QPoint beside = on_trunk();
    const double ratio = window_.view().devicePixelRatioF();
    while (window_.view().scene().pick(pixel_at(beside, ratio)).triangle >= 0)
        beside += QPoint(1, 0);
    click(beside + QPoint(2, 0));
    EXPECT_EQ(said(), "No vessel there: drag one (by keys: Enter with the cross on it)");
    click(on_trunk());
    EXPECT_EQ(said(), "");
    click(QPoint(4, 4));
    EXPECT_EQ(said(), "") << "nobody meant a vessel there";
    QTest::keyClick(&window_, Qt::Key_2);
    click(QPoint(4, 4));
    EXPECT_EQ(said(), "No vessel there: click on one (by keys: Enter with the cross on it)");
}

TEST_F(ToolInHand, a_reset_takes_it_and_the_next_move_brings_it_again) {
    take(Qt::Key_4);
    QTest::keyClick(&window_, Qt::Key_Backspace);
    paint();
    EXPECT_FALSE(window_.frame().tool);
    point_at(on_trunk() + QPoint(0, 5));
    EXPECT_EQ(count<AddTool>(), 2u);
}

TEST_F(ToolInHand, a_new_patient_is_told_that_there_will_be_tools) {
    take(Qt::Key_4);
    open_built_in();
    EXPECT_EQ(count<UseTools>(), 1u) << "of the new simulation";
    point_at(on_trunk());
    EXPECT_EQ(count<AddTool>(), 1u);
}

TEST_F(ToolInHand, stands_in_the_tool_bar_with_icon_key_and_tip) {
    auto* bar = window_.findChild<QToolBar*>("Tools");
    for (const ActionId id : {ActionId::pull_mode, ActionId::sphere_tool, ActionId::capsule_tool,
                              ActionId::forceps_tool, ActionId::hook_tool}) {
        EXPECT_TRUE(bar->actions().contains(&action(id)));
        const QImage icon = action(id).icon().pixmap(32, 32).toImage();
        int painted = 0;
        for (int y = 0; y < icon.height(); ++y)
            for (int x = 0; x < icon.width(); ++x) painted += qAlpha(icon.pixel(x, y)) > 0;
        EXPECT_GT(painted, 50);
        EXPECT_FALSE(action(id).shortcut().isEmpty());
        EXPECT_TRUE(action(id).toolTip().contains(action(id).shortcut().toString()));
    }
    QTest::keyClick(&window_, Qt::Key_5);
    EXPECT_TRUE(action(ActionId::capsule_tool).isChecked());
    EXPECT_FALSE(action(ActionId::pull_mode).isChecked());
}

}  // namespace
}  // namespace hepatica
