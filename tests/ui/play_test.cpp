// SPDX-License-Identifier: GPL-3.0-or-later
// The window with a real simulation behind it, on its own thread.
#include "tests/session/small_patient.h"
#include "tests/ui/window_test.h"
#include "ui/curves_dock.h"
#include "ui/plot_panel.h"

namespace hepatica {
namespace {

class Play : public testing::WindowTest {
  protected:
    Play()
        : WindowTest({[](const OpenRequest&, Job& job) { return play(test::small_patient(), job); },
                      write_case}) {
        open_built_in();
    }

    const Frame& frame() { return window_.frame(); }

    QPoint vertex_on_widget(int vertex) {
        const float* v = &frame().positions_mm[3 * static_cast<std::size_t>(vertex)];
        return on_widget(Vec3(v[0], v[1], v[2]));
    }
};

// The middle of the longest segment: the one that gives way most.
Vec3 softest_place() {
    const VesselTree& tree = test::small_patient()->tree;
    int longest = 0;
    for (int s = 0; s < static_cast<int>(tree.segments.size()); ++s) {
        const auto at = [&](int i) {
            return length_mm(tree.segments[static_cast<std::size_t>(i)]);
        };
        if (at(s) > at(longest)) longest = s;
    }
    return test::middle_of(tree, longest);
}

TEST_F(Play, the_grabbed_vertex_follows_the_mouse) {
    VtkWidget& view = window_.view();
    const QPoint start = on_widget(softest_place());
    const SurfacePick held = view.scene().pick(pixel_at(start, view.devicePixelRatioF()));
    ASSERT_GE(held.triangle, 0);
    const QPoint rest = vertex_on_widget(held.nearest_vertex);
    QTest::mousePress(&view, Qt::LeftButton, {}, start);
    QTest::mouseMove(&view, start + QPoint(20, 0));
    QTest::mouseMove(&view, start + QPoint(40, 0));
    EXPECT_TRUE(testing::wait_for([&] {
        return vertex_on_widget(held.nearest_vertex).x() - rest.x() > 5;
    })) << "moved by "
        << vertex_on_widget(held.nearest_vertex).x() - rest.x() << " points";
    EXPECT_TRUE(frame().grab.has_value());
    QTest::mouseRelease(&view, Qt::LeftButton, {}, start + QPoint(40, 0));
    EXPECT_TRUE(testing::wait_for([&] { return !frame().grab.has_value(); }));
    EXPECT_TRUE(testing::wait_for([&] {
        return std::abs(vertex_on_widget(held.nearest_vertex).x() - rest.x()) <= 2;
    })) << "it stays away from rest";
}

// A ball that is led in front of a vessel and then into it.
TEST_F(Play, a_probe_pushes_the_vessel_that_the_mouse_leads_it_into) {
    VtkWidget& view = window_.view();
    const auto point_at = [&](const QPoint& place) {
        QMouseEvent move(QEvent::MouseMove, place, view.mapToGlobal(place), Qt::NoButton,
                         Qt::NoButton, Qt::NoModifier);
        QApplication::sendEvent(&view, &move);
    };
    const QPoint place = on_widget(softest_place());
    QTest::keyClick(&window_, Qt::Key_4);
    point_at(place);
    ASSERT_TRUE(testing::wait_for([&] { return frame().tool.has_value(); }));
    const Vec3 begin = frame().tool->centre_mm;
    // By one notch a picture, as a hand does: deeper into the picture than the vessel is thick.
    for (int notch = 0; notch < 12; ++notch) {
        view.mouse().wheel(1.0);
        paint();
    }
    EXPECT_TRUE(testing::wait_for(
        [&] { return frame().tool->force_un.norm() > 100.0 && !frame().tool->touched.empty(); }));
    const Vec3 forward = view.scene().axes().forward;
    EXPECT_GT((frame().tool->centre_mm - begin).dot(forward), 0.3);
    EXPECT_LT(frame().tool->force_un.dot(forward), 0.0) << "it is pressed back";
    QTest::keyClick(&window_, Qt::Key_Escape);
    EXPECT_TRUE(testing::wait_for([&] { return !frame().tool.has_value(); }));
}

TEST_F(Play, a_double_click_sends_the_drug_downstream) {
    QTest::mouseDClick(&window_.view(), Qt::LeftButton, {}, on_widget(softest_place()));
    QTest::mouseRelease(&window_.view(), Qt::LeftButton, {}, on_widget(softest_place()));
    EXPECT_TRUE(testing::wait_for([&] { return frame().drug.arrival_s != nullptr; }));
    EXPECT_GT(frame().drug.end_s, 0.0);
    const double before = frame().drug.time_s;
    EXPECT_TRUE(testing::wait_for([&] { return frame().drug.time_s > before; }));
    // The curves that then appear are those of this very injection.
    auto& dock = static_cast<CurvesDock&>(*window_.findChild<QDockWidget*>("Curves"));
    const auto pressure = [&] { return dock.plots().left().curves; };
    ASSERT_TRUE(testing::wait_for([&] { return !pressure().empty(); }));
    EXPECT_DOUBLE_EQ(pressure().at(0).x.back(), frame().drug.end_s);
    EXPECT_TRUE(testing::wait_for([&] { return dock.isVisible(); }));
    // Nothing is injected any more.
    window_.actions()[ActionId::remove_drug].trigger();
    EXPECT_TRUE(testing::wait_for([&] { return pressure().empty(); }));
}

}  // namespace
}  // namespace hepatica
