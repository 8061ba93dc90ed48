// SPDX-License-Identifier: GPL-3.0-or-later
// Blade and cut line: what a line drawn across a vessel sends, and what the panel says of tears.
#include <QCheckBox>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <algorithm>

#include "tests/ui/fake_window_test.h"
#include "ui/message_bar.h"
#include "ui/plot_panel.h"

namespace hepatica {
namespace {

class TearTest : public testing::FakeWindowTest {
  protected:
    TearTest() { open_built_in(); }

    void draw(const QPoint& from, const QPoint& to) {
        QTest::mousePress(&window_.view(), Qt::LeftButton, {}, from);
        for (const QPoint& at : {(from + to) / 2, to}) {
            QMouseEvent move(QEvent::MouseMove, at, window_.view().mapToGlobal(at), Qt::NoButton,
                             Qt::LeftButton, Qt::NoModifier);
            QApplication::sendEvent(&window_.view(), &move);
        }
        QTest::mouseRelease(&window_.view(), Qt::LeftButton, {}, to);
    }
};

TEST_F(TearTest, a_blade_goes_along_the_line_at_the_vessels_depth) {
    QTest::keyClick(&window_, Qt::Key_8);
    draw(on_trunk() - QPoint(60, 5), on_trunk() + QPoint(60, 5));
    ASSERT_EQ(commands_of_type<Blade>().size(), 1u);
    ASSERT_EQ(commands_of_type<UseTear>().size(), 1u);
    EXPECT_TRUE(commands_of_type<UseTear>()[0].on);
    const Blade blade = commands_of_type<Blade>()[0];
    EXPECT_LE((on_widget(blade.from_mm) - on_trunk() + QPoint(60, 5)).manhattanLength(), 2);
    EXPECT_LE((on_widget(blade.to_mm) - on_trunk() - QPoint(60, 5)).manhattanLength(), 2);
    const Vec3 middle = 0.5 * (blade.from_mm + blade.to_mm);
    EXPECT_LT((middle - Vec3(0, 0, half_way_up_the_trunk_mm)).norm(), 8.0);
    EXPECT_EQ(commands_of_type<GrabPoint>().size(), 0u);
}

TEST_F(TearTest, a_cut_line_is_the_section_under_it) {
    window_.findChild<QDoubleSpinBox*>("lineStrength")->setValue(0.25);
    QTest::keyClick(&window_, Qt::Key_9);
    const auto shown = window_.findChild<QDockWidget*>("Tool")->findChildren<QLabel*>("quiet");
    EXPECT_TRUE(std::ranges::any_of(shown, [](const QLabel* label) {
        return label->text() ==
               "Draw a line across a vessel: it tears there when pulled (by keys: Enter, "
               "arrows, Enter)";
    })) << "and not to take a tool";
    draw(on_trunk() - QPoint(60, 0), on_trunk() + QPoint(60, 0));
    ASSERT_EQ(commands_of_type<CutLine>().size(), 1u);
    const CutLine line = commands_of_type<CutLine>()[0];
    EXPECT_EQ(line.strength, 0.25);
    EXPECT_EQ(line.from_mm, line.to_mm);
    EXPECT_LT((line.from_mm - Vec3(0, 0, half_way_up_the_trunk_mm)).norm(), 8.0);
}

// Over whatever vessels lie before the plane that it is drawn in, with a dark rim.
TEST_F(TearTest, the_line_that_is_drawn_is_seen_before_the_vessels) {
    QTest::keyClick(&window_, Qt::Key_8);
    const QPoint from = on_trunk() - QPoint(60, 0), to = on_trunk() + QPoint(60, 0);
    QTest::mousePress(&window_.view(), Qt::LeftButton, {}, from);
    QMouseEvent move(QEvent::MouseMove, to, window_.view().mapToGlobal(to), Qt::NoButton,
                     Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&window_.view(), &move);
    const QImage picture = window_.view().picture();
    const double ratio = window_.view().devicePixelRatioF();
    const auto brightest = [&](int from_px, int to_px) {
        int green = 0;
        for (int dy = from_px; dy <= to_px; ++dy)
            green = std::max(
                green, picture.pixelColor((QPointF(on_trunk()) * ratio).toPoint() + QPoint(0, dy))
                           .green());
        return green;
    };
    EXPECT_GT(brightest(-2, 2), 225) << "the line, across the trunk";
    int darkest = 255;
    for (int dy = -6; dy <= 6; ++dy)
        darkest = std::min(
            darkest, picture.pixelColor((QPointF(on_trunk()) * ratio).toPoint() + QPoint(0, dy))
                         .lightness());
    EXPECT_LT(darkest, 40) << "its rim";
    QTest::mouseRelease(&window_.view(), Qt::LeftButton, {}, to);
}

TEST_F(TearTest, a_line_beside_the_vessels_cuts_nothing) {
    QTest::keyClick(&window_, Qt::Key_8);
    draw(QPoint(5, 5), QPoint(40, 8));
    EXPECT_EQ(commands_of_type<Blade>().size(), 0u);
    EXPECT_EQ(commands_of_type<UseTear>().size(), 0u);
}

TEST_F(TearTest, escape_puts_the_blade_away) {
    QTest::keyClick(&window_, Qt::Key_8);
    EXPECT_EQ(window_.view().mouse().mode(), MouseMode::cut);
    QTest::keyClick(&window_, Qt::Key_Escape);
    EXPECT_EQ(window_.view().mouse().mode(), MouseMode::pull);
}

TEST_F(TearTest, escape_first_lets_go_of_the_vessel_and_of_the_line) {
    QTest::mousePress(&window_.view(), Qt::LeftButton, {}, on_trunk());
    ASSERT_EQ(commands_of_type<GrabPoint>().size(), 1u);
    QTest::keyClick(&window_, Qt::Key_Escape);
    EXPECT_EQ(commands_of_type<ReleaseGrab>().size(), 1u);
    EXPECT_FALSE(window_.view().mouse().pulling());
    QTest::mouseRelease(&window_.view(), Qt::LeftButton, {}, on_trunk());
    EXPECT_EQ(commands_of_type<ReleaseGrab>().size(), 1u);
    QTest::keyClick(&window_, Qt::Key_8);
    QTest::mousePress(&window_.view(), Qt::LeftButton, {}, on_trunk() - QPoint(60, 5));
    ASSERT_TRUE(window_.view().mouse().holds());
    QTest::keyClick(&window_, Qt::Key_Escape);
    EXPECT_FALSE(window_.view().mouse().holds());
    EXPECT_EQ(window_.view().mouse().mode(), MouseMode::cut) << "once more puts it away";
    QTest::mouseRelease(&window_.view(), Qt::LeftButton, {}, on_trunk() + QPoint(60, 5));
    EXPECT_EQ(commands_of_type<Blade>().size(), 0u);
}

TEST_F(TearTest, of_undo_it_is_said_that_it_takes_no_cut_back_and_what_does) {
    const auto press_undo = [this] { QTest::keyClick(&window_, Qt::Key_Z, Qt::ControlModifier); };
    press_undo();
    EXPECT_EQ(window_.messages().text(), "") << "nothing is cut";
    TearView cut;
    cut.joints_broken = 4;
    simulation_->show_tear(cut);
    ASSERT_TRUE(testing::wait_for(
        [this] { return window_.frame().tear && window_.frame().tear->joints_broken == 4; }));
    press_undo();
    EXPECT_TRUE(window_.messages().text().contains("Reset (Backspace) makes the vessels whole"));
    const auto buttons = window_.messages().findChildren<QPushButton*>();
    const auto reset = std::ranges::find_if(
        buttons, [](const QPushButton* button) { return button->text() == "Reset"; });
    ASSERT_NE(reset, buttons.end());
    (*reset)->click();
    EXPECT_EQ(commands_of_type<ResetWorld>().size(), 1u);
    EXPECT_EQ(window_.messages().text(), "");
}

TEST_F(TearTest, that_cuts_stay_is_said_no_more_once_all_is_whole_again) {
    TearView cut;
    cut.joints_broken = 4;
    simulation_->show_tear(cut);
    ASSERT_TRUE(testing::wait_for(
        [this] { return window_.frame().tear && window_.frame().tear->joints_broken == 4; }));
    QTest::keyClick(&window_, Qt::Key_Z, Qt::ControlModifier);
    ASSERT_TRUE(window_.messages().text().contains("Reset (Backspace) makes the vessels whole"));
    wait_for_figures();
    EXPECT_NE(window_.messages().text(), "") << "they are cut still";
    simulation_->show_tear(TearView{});
    EXPECT_TRUE(testing::wait_for([this] { return window_.messages().text().isEmpty(); }));
}

TEST_F(TearTest, the_foot_of_the_window_says_how_fast_it_bleeds) {
    const auto* foot = window_.findChild<QLabel*>("bleeding");
    EXPECT_TRUE(foot->isHidden());
    TearView cut;
    cut.leak_g_s = 6.7;
    simulation_->show_tear(cut);
    EXPECT_TRUE(testing::wait_for([&] { return foot->text().endsWith("bleeds 6.7 g/s"); }));
    EXPECT_FALSE(foot->isHidden());
    simulation_->show_tear(TearView{});
    EXPECT_TRUE(testing::wait_for([&] { return foot->isHidden(); }));
}

TEST_F(TearTest, the_panel_switches_tearing_with_its_factor) {
    auto* factor = window_.findChild<QDoubleSpinBox*>("tearFactor");
    factor->setValue(0.1);
    EXPECT_EQ(commands_of_type<UseTear>().size(), 0u) << "nothing tears yet";
    window_.findChild<QCheckBox*>("vesselsTear")->click();
    ASSERT_EQ(commands_of_type<UseTear>().size(), 1u);
    EXPECT_TRUE(commands_of_type<UseTear>()[0].on);
    EXPECT_EQ(commands_of_type<UseTear>()[0].tear_factor, 0.1);
}

TEST_F(TearTest, the_curves_of_a_tear_show_what_happened_to_who_asks_for_them) {
    auto* dock = window_.findChild<QDockWidget*>("Curves");
    ASSERT_TRUE(dock->isHidden());
    simulation_->show_tear(TearView{});
    auto* panel = dynamic_cast<PlotPanel*>(dock->widget());
    ASSERT_TRUE(testing::wait_for([&] { return !panel->tear().chart().curves.empty(); }));
    TearView torn;
    torn.joints_broken = 4;
    torn.pieces = 2;
    torn.leak_g_s = 2.5;
    simulation_->show_tear(torn);
    ASSERT_TRUE(testing::wait_for([&] { return panel->tear().events().size() == 3; }));
    EXPECT_TRUE(dock->isHidden()) << "it takes no room unasked";
    window_.actions()[ActionId::toggle_plots].trigger();
    EXPECT_EQ(panel->tear().events()[0].text, "cut or torn");
    EXPECT_EQ(panel->tear().events()[2].text, "bleeding");
    EXPECT_TRUE(panel->tear().isVisible());
    simulation_->show_tear(std::nullopt);
    ASSERT_TRUE(testing::wait_for([&] { return !panel->tear().isVisible(); }));
}

}  // namespace
}  // namespace hepatica
