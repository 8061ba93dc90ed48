// SPDX-License-Identifier: GPL-3.0-or-later
// What drags of each button do to the camera, by the scheme of the mouse that was chosen.
#include "ui/mouse_scheme.h"

#include "tests/ui/fake_window_test.h"

namespace hepatica {
namespace {

class MouseSchemes : public testing::FakeWindowTest {
  protected:
    MouseSchemes() { open_built_in(); }

    struct Camera {
        Vec3 focus, forward;
        double mm_per_pixel;
    };
    Camera camera() {
        const ViewAxes axes = window_.view().scene().axes();
        const Vec3 right = window_.view().scene().point_at_depth({101, 100}, axes.focus_mm) -
                           window_.view().scene().point_at_depth({100, 100}, axes.focus_mm);
        return {axes.focus_mm, axes.forward, right.norm()};
    }
    // By a few pixels down and to the right from a corner, where no vessel is.
    // `soon`: so soon after the last that Qt takes it for the second press of a double click.
    std::optional<CameraGesture> drag(Qt::MouseButton button, Qt::KeyboardModifiers keys = {},
                                      bool soon = false) {
        const Camera before = camera();
        const QPoint from(15, 15), to(55, 75);
        if (soon)
            QTest::mouseDClick(&window_.view(), button, keys, from);
        else
            QTest::mousePress(&window_.view(), button, keys, from);
        QMouseEvent move(QEvent::MouseMove, to, window_.view().mapToGlobal(to), Qt::NoButton,
                         button, keys);
        QApplication::sendEvent(&window_.view(), &move);
        QTest::mouseRelease(&window_.view(), button, keys, to);
        const Camera after = camera();
        if ((after.forward - before.forward).norm() > 1e-6) return CameraGesture::orbit;
        if (std::abs(after.mm_per_pixel / before.mm_per_pixel - 1.0) > 1e-6)
            return CameraGesture::zoom;
        if ((after.focus - before.focus).norm() > 1e-6) return CameraGesture::pan;
        return std::nullopt;
    }
    void choose(const char* scheme) {
        auto* action = window_.findChild<QAction*>(QString("mouse_") + scheme);
        ASSERT_NE(action, nullptr);
        action->trigger();
        EXPECT_TRUE(action->isChecked());
    }
};

TEST_F(MouseSchemes, each_button_turns_moves_or_zooms_the_view) {
    using enum CameraGesture;
    EXPECT_EQ(drag(Qt::LeftButton), orbit);
    EXPECT_EQ(drag(Qt::RightButton), orbit);
    EXPECT_EQ(drag(Qt::MiddleButton), pan);
    EXPECT_EQ(drag(Qt::LeftButton, Qt::ShiftModifier), pan);
    choose("slicer");
    EXPECT_EQ(drag(Qt::LeftButton), orbit);
    EXPECT_EQ(drag(Qt::RightButton), zoom);
    EXPECT_EQ(drag(Qt::MiddleButton), pan);
    EXPECT_EQ(drag(Qt::LeftButton, Qt::ShiftModifier), pan);
    choose("construction");
    EXPECT_EQ(drag(Qt::LeftButton), orbit);
    EXPECT_EQ(drag(Qt::RightButton), pan);
    EXPECT_EQ(drag(Qt::MiddleButton), orbit);
    EXPECT_EQ(drag(Qt::MiddleButton, Qt::ControlModifier), pan);
    EXPECT_EQ(drag(Qt::MiddleButton, Qt::ShiftModifier), zoom);
}

TEST_F(MouseSchemes, a_drag_right_after_another_does_the_same) {
    using enum CameraGesture;
    EXPECT_EQ(drag(Qt::LeftButton, {}, true), orbit);
    EXPECT_EQ(drag(Qt::RightButton, {}, true), orbit);
    EXPECT_EQ(drag(Qt::MiddleButton, {}, true), pan);
    EXPECT_EQ(drag(Qt::LeftButton, Qt::ShiftModifier, true), pan);
    QTest::mouseDClick(&window_.view(), Qt::LeftButton, Qt::ShiftModifier, on_trunk());
    QTest::mouseRelease(&window_.view(), Qt::LeftButton, Qt::ShiftModifier, on_trunk());
    EXPECT_TRUE(commands_of_type<InjectDrug>().empty()) << "it moves the view";
    window_.view().mouse().set_mode(MouseMode::cut);
    QTest::mouseDClick(&window_.view(), Qt::LeftButton, {}, QPoint(15, 15));
    EXPECT_TRUE(window_.view().mouse().holds()) << "the next line";
}

TEST_F(MouseSchemes, in_every_one_the_left_button_pulls) {
    for (const MouseScheme& scheme : mouse_schemes()) {
        choose(scheme.name);
        const std::size_t before = commands_of_type<GrabPoint>().size();
        QTest::mousePress(&window_.view(), Qt::LeftButton, {}, on_trunk());
        QTest::mouseRelease(&window_.view(), Qt::LeftButton, {}, on_trunk());
        EXPECT_EQ(commands_of_type<GrabPoint>().size(), before + 1) << scheme.name;
    }
}

TEST_F(MouseSchemes, is_remembered) {
    choose("slicer");
    EXPECT_EQ(settings_.mouse_scheme(), "slicer");
    EXPECT_STREQ(mouse_scheme_named("slicer").name, "slicer");
    EXPECT_STREQ(mouse_scheme_named("of another program").name, "usual");
}

}  // namespace
}  // namespace hepatica
