// SPDX-License-Identifier: GPL-3.0-or-later
// The view of the vessels without a mouse, and a click in it that leads the slices.
#include "ui/key_tool.h"

#include "tests/ui/slices_test.h"
#include "ui/view_focus.h"

namespace hepatica {
namespace {

class ViewKeys : public testing::FakeWindowTest {
  protected:
    void begin() {
        open_built_in();
        view().clearFocus();  // it may have come otherwise
        view().setFocus(Qt::TabFocusReason);
        ASSERT_TRUE(testing::wait_for([this] { return view().hasFocus(); }));
    }
    void press(Qt::Key key, Qt::KeyboardModifiers modifiers = {}) {
        QTest::keyClick(&view(), key, modifiers);
    }
    // Until the cross in the middle lies on the trunk.
    void aim_at_trunk() {
        const QPoint middle = view().rect().center();
        for (int i = 0; i < 60; ++i) {
            const QPoint off = on_trunk() - middle;
            if (std::abs(off.x()) < 6 && std::abs(off.y()) < 12) return;
            if (std::abs(off.x()) >= 6)
                press(off.x() > 0 ? Qt::Key_Left : Qt::Key_Right, Qt::ShiftModifier);
            else
                press(off.y() > 0 ? Qt::Key_Up : Qt::Key_Down, Qt::ShiftModifier);
            paint();
            if (i % 20 == 19) press(Qt::Key_Plus);
        }
    }
    // Until the cross lies on no vessel.
    void aim_beside_vessels() {
        paint();
        for (int i = 0; i < 60 && view().scene().pick(view().keys().aim()).triangle >= 0; ++i) {
            press(Qt::Key_Left, Qt::ShiftModifier);
            paint();
        }
        ASSERT_LT(view().scene().pick(view().keys().aim()).triangle, 0);
    }
    void take_probe() {
        press(Qt::Key_4);
        press(Qt::Key_Return);
        ASSERT_TRUE(testing::wait_for([this] { return window_.frame().tool.has_value(); }));
    }
    // Beyond the middle of what is looked at.
    double depth_of(const Vec3& place) {
        const ViewAxes axes = view().scene().axes();
        return (place - axes.focus_mm).dot(axes.forward);
    }
    // A place so far beyond that, and so far to the right of the cross.
    Vec3 mark_at_aim(double depth_mm, double beside_points) {
        const ViewAxes axes = view().scene().axes();
        Pixel pixel = view().keys().aim();
        pixel.x += beside_points * view().devicePixelRatioF();
        return view().scene().point_at_depth(pixel, axes.focus_mm + depth_mm * axes.forward);
    }
    VtkWidget& view() { return window_.view(); }
    const Vec3 tip_{30, 0, 40};
};

TEST_F(ViewKeys, TurnPanAndZoom) {
    begin();
    const ViewAxes before = view().scene().axes();
    press(Qt::Key_Right);
    const double turned =
        std::acos(std::clamp(view().scene().axes().forward.dot(before.forward), -1.0, 1.0));
    EXPECT_NEAR(turned * 180.0 / std::acos(-1.0), 5.0, 0.01);
    press(Qt::Key_Left);
    EXPECT_NEAR((view().scene().axes().forward - before.forward).norm(), 0.0, 1e-6);
    press(Qt::Key_Up);
    EXPECT_GT((view().scene().axes().forward - before.forward).norm(), 0.05);
    press(Qt::Key_Down);
    const QPoint there = on_widget(tip_);
    press(Qt::Key_Right, Qt::ShiftModifier);
    EXPECT_GT(on_widget(tip_).x(), there.x() + 5);
    press(Qt::Key_Left, Qt::ShiftModifier);
    EXPECT_LE((on_widget(tip_) - there).manhattanLength(), 2);
    const QPoint foot = on_widget(Vec3(0, 0, -60));
    const double apart = QLineF(foot, there).length();
    press(Qt::Key_Plus);
    EXPECT_GT(QLineF(on_widget(Vec3(0, 0, -60)), on_widget(tip_)).length(), 1.1 * apart);
    press(Qt::Key_Minus);
    press(Qt::Key_Minus);
    EXPECT_LT(QLineF(on_widget(Vec3(0, 0, -60)), on_widget(tip_)).length(), 0.95 * apart);
    EXPECT_TRUE(simulation_->commands().empty());
}

TEST_F(ViewKeys, HomeShowsAllFromWhereOneLooks) {
    begin();
    press(Qt::Key_Right);
    press(Qt::Key_Right);
    const Vec3 forward = view().scene().axes().forward;
    for (int i = 0; i < 12; ++i) press(Qt::Key_Plus);
    for (int i = 0; i < 8; ++i) press(Qt::Key_Right, Qt::ShiftModifier);
    EXPECT_FALSE(view().rect().contains(on_widget(tip_)));
    press(Qt::Key_Home);
    EXPECT_NEAR((view().scene().axes().forward - forward).norm(), 0.0, 1e-6);
    EXPECT_TRUE(view().rect().contains(on_widget(tip_)));
    EXPECT_TRUE(view().rect().contains(on_widget(Vec3(0, 0, -60))));
}

TEST_F(ViewKeys, EnterTakesHoldArrowsPullAndEnterLetsGo) {
    begin();
    aim_at_trunk();
    press(Qt::Key_Return);
    ASSERT_EQ(commands_of_type<GrabPoint>().size(), 1u);
    EXPECT_TRUE(view().keys().leads());
    const ViewAxes before = view().scene().axes();
    for (int i = 0; i < 5; ++i) press(Qt::Key_Right);
    const auto moves = commands_of_type<MoveGrab>();
    ASSERT_EQ(moves.size(), 5u);
    EXPECT_GT((moves.back().target_mm - commands_of_type<GrabPoint>()[0].point_mm)
                  .dot(view().scene().axes().right),
              1.0);
    EXPECT_EQ(view().scene().axes().forward, before.forward) << "nothing turns meanwhile";
    for (int i = 0; i < 5; ++i) press(Qt::Key_Left);  // this trunk stays where it was led
    press(Qt::Key_Return);
    EXPECT_EQ(commands_of_type<ReleaseGrab>().size(), 1u);
    EXPECT_FALSE(view().keys().leads());
    const auto take_hold_again = [this] {
        paint();
        aim_at_trunk();
        press(Qt::Key_Return);
        EXPECT_TRUE(view().keys().leads());
        return commands_of_type<GrabPoint>().size();
    };
    ASSERT_EQ(take_hold_again(), 2u);
    press(Qt::Key_Escape);
    EXPECT_EQ(commands_of_type<ReleaseGrab>().size(), 2u);
    EXPECT_FALSE(view().keys().leads());
    ASSERT_EQ(take_hold_again(), 3u);
    view().clearFocus();
    EXPECT_EQ(commands_of_type<ReleaseGrab>().size(), 3u);
    EXPECT_FALSE(view().keys().leads());
}

TEST_F(ViewKeys, EnterDoesWhatAClickDoesInOtherModes) {
    begin();
    aim_at_trunk();
    press(Qt::Key_2);
    press(Qt::Key_Return);
    EXPECT_EQ(commands_of_type<InjectDrug>().size(), 1u);
    EXPECT_FALSE(view().keys().leads());
    press(Qt::Key_1);
    press(Qt::Key_Return, Qt::ControlModifier);
    EXPECT_EQ(commands_of_type<InjectDrug>().size(), 2u);
    EXPECT_TRUE(commands_of_type<GrabPoint>().empty());
}

TEST_F(ViewKeys, LeadATool) {
    begin();
    press(Qt::Key_4);
    press(Qt::Key_Return);
    ASSERT_EQ(commands_of_type<AddTool>().size(), 1u);
    ASSERT_TRUE(testing::wait_for([this] { return window_.frame().tool.has_value(); }));
    const std::size_t before = commands_of_type<MoveTool>().size();
    press(Qt::Key_Up);
    EXPECT_GT(commands_of_type<MoveTool>().size(), before);
    press(Qt::Key_PageUp);
    press(Qt::Key_Escape);
    EXPECT_FALSE(view().keys().leads());
    EXPECT_EQ(view().mouse().mode(), MouseMode::tool) << "once more puts it away";
    press(Qt::Key_Escape);
    EXPECT_EQ(view().mouse().mode(), MouseMode::pull);
}

TEST_F(ViewKeys, ShiftMovesAToolFiveTimesAsFarInDepth) {
    begin();
    take_probe();
    const double before = depth_of(window_.frame().tool->tip_mm);
    press(Qt::Key_PageUp, Qt::ShiftModifier);
    EXPECT_NEAR(depth_of(commands_of_type<MoveTool>().back().target_mm) - before, 5.0, 1e-9);
    press(Qt::Key_PageUp);
    EXPECT_NEAR(depth_of(commands_of_type<MoveTool>().back().target_mm) - before, 6.0, 1e-9);
    press(Qt::Key_PageDown, Qt::ShiftModifier);
    EXPECT_NEAR(depth_of(commands_of_type<MoveTool>().back().target_mm) - before, 1.0, 1e-9);
}

// Else it comes at the depth of the view's middle.
TEST_F(ViewKeys, EnterBringsAToolToTheDepthOfAMark) {
    begin();
    aim_beside_vessels();
    const auto brought_to = [this](double beside_points, bool reached) {
        press(Qt::Key_4);
        view().scene().set_marks({{mark_at_aim(25.0, beside_points), "", reached}});
        press(Qt::Key_Return);
        press(Qt::Key_Escape);
        press(Qt::Key_Escape);
        return depth_of(commands_of_type<AddTool>().back().point_mm);
    };
    EXPECT_NEAR(brought_to(0.0, false), 25.0, 1e-6);
    EXPECT_NEAR(brought_to(16.0, false), 25.0, 1e-6) << "near it";
    EXPECT_NEAR(brought_to(40.0, false), 0.0, 1e-6);
    EXPECT_NEAR(brought_to(0.0, true), 0.0, 1e-6) << "it is done with";
}

TEST_F(ViewKeys, EnterOnAVesselBringsAToolToItUnlessAMarkLiesElsewhere) {
    begin();
    aim_at_trunk();
    paint();
    const double surface = depth_of(view().scene().pick(view().keys().aim()).position_mm);
    const auto brought_to = [&](double depth_mm, double beside_points) {
        press(Qt::Key_4);
        view().scene().set_marks({{mark_at_aim(depth_mm, beside_points), ""}});
        press(Qt::Key_Return);
        press(Qt::Key_Escape);
        press(Qt::Key_Escape);
        return depth_of(commands_of_type<AddTool>().back().point_mm);
    };
    EXPECT_NEAR(brought_to(surface + 4.0, 0.0), surface, 1e-6) << "the mark lies in that vessel";
    EXPECT_NEAR(brought_to(surface + 30.0, 0.0), surface + 30.0, 1e-6);
    EXPECT_NEAR(brought_to(surface + 30.0, 16.0), surface, 1e-6) << "the vessel is meant";
}

TEST_F(ViewKeys, EnterBringsAToolInHandToAMarkAtAnotherDepthAndThenLetsGo) {
    begin();
    aim_beside_vessels();
    take_probe();
    press(Qt::Key_Right);
    paint();
    const Vec3 mark = mark_at_aim(25.0, 0.0);
    view().scene().set_marks({{mark, ""}});
    press(Qt::Key_Return);
    ASSERT_EQ(commands_of_type<AddTool>().size(), 2u);
    EXPECT_LT((commands_of_type<AddTool>().back().point_mm - mark).norm(), 1e-6);
    EXPECT_TRUE(view().keys().leads());
    paint();
    view().scene().set_marks({{mark, ""}});
    press(Qt::Key_Return);
    EXPECT_EQ(commands_of_type<AddTool>().size(), 2u) << "it is there";
    EXPECT_FALSE(view().keys().leads());
}

// As where a tumour stands in the way: the tool does not come as deep as the mark lies.
TEST_F(ViewKeys, EnterLetsAToolGoThatDoesNotComeToWhereItWasBrought) {
    begin();
    aim_beside_vessels();
    take_probe();
    press(Qt::Key_Right);
    paint();
    view().scene().set_marks({{mark_at_aim(25.0, 0.0), ""}});
    press(Qt::Key_Return);
    ASSERT_EQ(commands_of_type<AddTool>().size(), 2u);
    paint();
    view().scene().set_marks({{mark_at_aim(50.0, 0.0), ""}});
    press(Qt::Key_Return);
    EXPECT_EQ(commands_of_type<AddTool>().size(), 2u);
    EXPECT_FALSE(view().keys().leads());
}

// It says where Enter will bring it.
TEST_F(ViewKeys, AToolThatIsChosenByItsKeyShowsTheAimAtOnce) {
    open_built_in();
    view().clearFocus();
    view().setFocus(Qt::OtherFocusReason);
    ASSERT_TRUE(testing::wait_for([this] { return view().hasFocus(); }));
    const auto aim = [this] { return view().focus_mark().aim().has_value(); };
    ASSERT_FALSE(aim());
    window_.actions()[ActionId::capsule_tool].trigger();
    EXPECT_FALSE(aim()) << "not by a key";
    press(Qt::Key_4);
    EXPECT_TRUE(aim());
    QMouseEvent move(QEvent::MouseMove, QPoint(30, 30), view().mapToGlobal(QPoint(30, 30)),
                     Qt::NoButton, Qt::NoButton, Qt::NoModifier);
    QApplication::sendEvent(&view(), &move);
    EXPECT_FALSE(aim()) << "the mouse leads it";
    window_.actions()[ActionId::forceps_tool].trigger();
    EXPECT_FALSE(aim()) << "the key was let go before";
}

TEST_F(ViewKeys, AFrameShowsThatTheViewHasThem) {
    begin();
    EXPECT_TRUE(view().focus_mark().isVisible());
    EXPECT_TRUE(view().focus_mark().aim().has_value());
    QTest::mouseClick(&view(), Qt::LeftButton, {}, QPoint(20, 20));
    EXPECT_FALSE(view().focus_mark().aim().has_value()) << "the mouse has its own";
    EXPECT_TRUE(view().focus_mark().isVisible());
    view().clearFocus();
    EXPECT_FALSE(view().focus_mark().isVisible());
}

class ClickForSlices : public testing::SlicesTest {
  protected:
    Vec3 crosshair() { return scene().crosshair_mm(); }
};

TEST_F(ClickForSlices, LeadsTheCrosshairThere) {
    show_slices();
    paint();
    scene().set_crosshair(Vec3(20, 20, 20));
    QTest::mouseClick(&window_.view(), Qt::LeftButton, {}, on_trunk());
    EXPECT_NEAR(crosshair().z(), half_way_up_the_trunk_mm, 6.0);
    EXPECT_LT(Vec3(crosshair().x(), crosshair().y(), 0.0).norm(), 2.0) << "on the centreline";
    // A pull is no click, nor is what another mode does.
    scene().set_crosshair(Vec3(21, 21, 21));
    const Vec3 put = crosshair();
    QTest::mousePress(&window_.view(), Qt::LeftButton, {}, on_trunk());
    QTest::mouseMove(&window_.view(), on_trunk() + QPoint(30, 0));
    QTest::mouseRelease(&window_.view(), Qt::LeftButton, {}, on_trunk() + QPoint(30, 0));
    EXPECT_EQ(crosshair(), put);
    window_.actions()[ActionId::inject_mode].trigger();
    paint();
    QTest::mouseClick(&window_.view(), Qt::LeftButton, {}, on_trunk());
    EXPECT_EQ(crosshair(), put);
}

}  // namespace
}  // namespace hepatica
