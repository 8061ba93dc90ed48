// SPDX-License-Identifier: GPL-3.0-or-later
// What the panels leave alone: numbers under a wheel that scrolls, curves that were closed, words
// at the edge of a plot.
#include <gtest/gtest.h>

#include <QAbstractItemView>
#include <QComboBox>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QListWidget>
#include <QProgressBar>
#include <QPushButton>
#include <QSlider>
#include <QTabBar>
#include <QWheelEvent>
#include <algorithm>
#include <set>

#include "tests/ui/fake_window_test.h"
#include "ui/curves_dock.h"
#include "ui/edit_panel.h"
#include "ui/elided_label.h"
#include "ui/message_bar.h"
#include "ui/plot_panel.h"
#include "ui/progress_strip.h"
#include "ui/theme.h"

namespace hepatica {
namespace {

void turn_wheel(QWidget& widget) {
    const QPointF middle = QRectF(widget.rect()).center();
    QWheelEvent event(middle, widget.mapToGlobal(middle), {}, {0, -120}, Qt::NoButton,
                      Qt::NoModifier, Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(&widget, &event);
}

class PanelsTest : public testing::FakeWindowTest {
  protected:
    CurvesDock& curves() {
        return static_cast<CurvesDock&>(*window_.findChild<QDockWidget*>("Curves"));
    }
    Frame torn(int joints) const {
        Frame frame;
        frame.time_s = joints;
        frame.tear.emplace();
        frame.tear->joints_broken = joints;
        return frame;
    }
};

TEST_F(PanelsTest, the_wheel_changes_what_has_the_focus_and_nothing_else) {
    open_built_in();
    auto& flow = *window_.findChild<QDoubleSpinBox*>("flow");
    auto& preset = *window_.findChild<QComboBox*>("flowUnits");
    auto& opacity = *window_.findChild<QSlider*>("dial");
    window_.view().setFocus();
    const double value = flow.value();
    const int choice = preset.currentIndex(), place = opacity.value();
    for (QWidget* field : {static_cast<QWidget*>(&flow), static_cast<QWidget*>(&preset),
                           static_cast<QWidget*>(&opacity)})
        turn_wheel(*field);
    EXPECT_EQ(flow.value(), value);
    EXPECT_EQ(preset.currentIndex(), choice);
    EXPECT_EQ(opacity.value(), place);
    EXPECT_FALSE(flow.hasFocus()) << "the wheel gives it none";
    flow.setFocus();
    turn_wheel(flow);
    EXPECT_LT(flow.value(), value);
    preset.setFocus();
    turn_wheel(preset);
    EXPECT_NE(preset.currentIndex(), choice);
}

TEST_F(PanelsTest, escape_closes_an_open_list_and_keeps_the_tool) {
    open_built_in();
    QTest::keyClick(&window_, Qt::Key_4);
    ASSERT_EQ(window_.view().mouse().mode(), MouseMode::tool);
    auto& units = *window_.findChild<QComboBox*>("flowUnits");
    units.showPopup();
    ASSERT_TRUE(units.view()->isVisible());
    QTest::keyClick(units.view(), Qt::Key_Escape);
    EXPECT_TRUE(testing::wait_for([&] { return !units.view()->isVisible(); }));
    EXPECT_EQ(window_.view().mouse().mode(), MouseMode::tool);
    QTest::keyClick(&window_, Qt::Key_Escape);
    EXPECT_NE(window_.view().mouse().mode(), MouseMode::tool) << "no list is open any more";
}

TEST_F(PanelsTest, the_mode_that_edits_brings_its_panel_to_the_front_even_if_it_was_closed) {
    open_built_in();
    auto& corrections = *window_.findChild<QDockWidget*>("Corrections");
    corrections.close();
    ASSERT_FALSE(corrections.isVisible());
    QTest::keyClick(&window_, Qt::Key_3);
    EXPECT_TRUE(corrections.isVisible());
    EXPECT_TRUE(testing::wait_for([&] { return !corrections.visibleRegion().isEmpty(); }));
}

// A button that had the keyboard and cannot be pressed any more gives it to whatever comes next,
// which may lie in a panel behind another.
TEST_F(PanelsTest, the_panel_in_front_stays_there_where_the_keyboard_goes_on_by_itself) {
    open_built_in();
    auto& corrections = *window_.findChild<QDockWidget*>("Corrections");
    auto& injection = *window_.findChild<QDockWidget*>("Injection");
    corrections.raise();
    ASSERT_TRUE(testing::wait_for([&] { return !corrections.visibleRegion().isEmpty(); }));
    for (QWidget* field : corrections.findChildren<QWidget*>()) {
        if (!field->isVisible() || !field->isEnabled() || field->focusPolicy() == Qt::NoFocus)
            continue;
        field->setFocus();
        field->setEnabled(false);
        EXPECT_TRUE(injection.visibleRegion().isEmpty()) << field->objectName().toStdString();
        EXPECT_FALSE(corrections.visibleRegion().isEmpty()) << field->objectName().toStdString();
        corrections.raise();
        field->setEnabled(true);
    }
    // The message above the view goes with the button that was pressed.
    window_.messages().show_notice("A notice", "Do it", [] {});
    QCoreApplication::processEvents();
    QTest::mouseClick(window_.messages().findChild<QPushButton*>("offer"), Qt::LeftButton);
    QCoreApplication::processEvents();
    EXPECT_TRUE(injection.visibleRegion().isEmpty());
    EXPECT_TRUE(window_.view().hasFocus()) << "not a field that nobody sees";
}

// By the tabs, which are on the way of the key: it does not swap what somebody is reading.
TEST_F(PanelsTest, a_panel_behind_another_is_reached_by_its_tab) {
    open_built_in();
    auto& corrections = *window_.findChild<QDockWidget*>("Corrections");
    auto& injection = *window_.findChild<QDockWidget*>("Injection");
    injection.raise();
    ASSERT_TRUE(testing::wait_for([&] { return !injection.visibleRegion().isEmpty(); }));
    corrections.raise();
    ASSERT_TRUE(testing::wait_for([&] { return injection.visibleRegion().isEmpty(); }));
    window_.view().setFocus();
    for (int presses = 0; presses < 60; ++presses) {
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
        EXPECT_FALSE(corrections.visibleRegion().isEmpty());
        auto* tabs = qobject_cast<QTabBar*>(QApplication::focusWidget());
        if (tabs == nullptr || tabs->tabText(tabs->currentIndex()) != corrections.windowTitle())
            continue;
        for (int tab = 0; tab < tabs->count(); ++tab) QTest::keyClick(tabs, Qt::Key_Left);
        while (tabs->tabText(tabs->currentIndex()) != injection.windowTitle() &&
               tabs->currentIndex() + 1 < tabs->count())
            QTest::keyClick(tabs, Qt::Key_Right);
        EXPECT_TRUE(testing::wait_for([&] { return !injection.visibleRegion().isEmpty(); }));
        return;
    }
    FAIL() << "no tabs on the way";
}

// Keys would change there what nobody sees.
TEST_F(PanelsTest, the_tab_key_goes_to_nothing_that_is_out_of_sight) {
    open_built_in();
    auto& tool = *window_.findChild<QDockWidget*>("Tool");
    tool.raise();
    ASSERT_TRUE(testing::wait_for([&] { return !tool.visibleRegion().isEmpty(); }));
    window_.view().setFocus();
    std::set<QWidget*> stops;
    for (QWidget* stop = QApplication::focusWidget(); stop && stops.insert(stop).second;
         stop = QApplication::focusWidget()) {
        // Its canvas covers the view.
        EXPECT_TRUE(stop == &window_.view() || !stop->visibleRegion().isEmpty())
            << stop->metaObject()->className() << " " << stop->objectName().toStdString();
        QTest::keyClick(stop, Qt::Key_Tab);
        QCoreApplication::processEvents();
    }
    EXPECT_GT(stops.size(), 15u);
    EXPECT_FALSE(stops.contains(window_.findChild<QDoubleSpinBox*>("flow")))
        << "in a panel behind another";
    EXPECT_FALSE(tool.visibleRegion().isEmpty()) << "which stays there";
    window_.view().setFocus();
    QTest::keyClick(&window_.view(), Qt::Key_Backtab);
    QWidget* before = QApplication::focusWidget();
    ASSERT_NE(before, &window_.view());
    QTest::keyClick(before, Qt::Key_Tab);
    EXPECT_TRUE(window_.view().hasFocus()) << "the way back is the same";
}

TEST_F(PanelsTest, the_keyboard_leaves_a_panel_that_goes_behind_another) {
    open_built_in();
    auto& flow = *window_.findChild<QDoubleSpinBox*>("flow");
    flow.setFocus();
    ASSERT_TRUE(flow.hasFocus());
    auto& tool = *window_.findChild<QDockWidget*>("Tool");
    tool.raise();
    ASSERT_TRUE(testing::wait_for([&] { return !tool.visibleRegion().isEmpty(); }));
    EXPECT_TRUE(window_.view().hasFocus());
}

// The first tear is watched in the view, whose room they would take.
TEST_F(PanelsTest, curves_do_not_come_for_a_tear) {
    open_built_in();
    curves().follow_tear(torn(0));
    curves().follow_tear(torn(1));
    curves().set_time(std::nullopt);
    EXPECT_FALSE(curves().isVisible());
    window_.actions()[ActionId::toggle_plots].trigger();
    EXPECT_EQ(curves().plots().tear().events().size(), 1u) << "they are kept for who asks";
}

// Their room is the view's: what is dragged would be thrown to another place.
TEST_F(PanelsTest, curves_come_when_the_hand_has_let_go) {
    open_built_in();
    bool drags = true;
    curves().hand_drags = [&drags] { return drags; };
    curves().come();
    curves().set_time(std::nullopt);
    EXPECT_FALSE(curves().isVisible());
    drags = false;
    curves().set_time(std::nullopt);
    EXPECT_TRUE(curves().isVisible());
    drags = true;
    curves().clear();
    curves().come();
    curves().clear();
    drags = false;
    curves().set_time(std::nullopt);
    EXPECT_FALSE(curves().isVisible()) << "nothing is left to show";
}

TEST_F(PanelsTest, curves_that_are_still_to_come_do_not_once_they_are_put_away) {
    open_built_in();
    bool drags = true;
    curves().hand_drags = [&drags] { return drags; };
    curves().come();
    QAction& shown = window_.actions()[ActionId::toggle_plots];
    shown.trigger();
    ASSERT_TRUE(curves().isVisible());
    shown.trigger();
    drags = false;
    curves().set_time(std::nullopt);
    EXPECT_FALSE(curves().isVisible());
}

TEST_F(PanelsTest, curves_that_came_by_themselves_go_when_nothing_is_left_to_show) {
    open_built_in();
    curves().come();
    ASSERT_TRUE(curves().isVisible());
    curves().clear();
    EXPECT_FALSE(curves().isVisible());
    window_.actions()[ActionId::toggle_plots].trigger();
    curves().clear();
    EXPECT_TRUE(curves().isVisible()) << "they were asked for";
}

TEST_F(PanelsTest, curves_that_were_closed_come_when_they_are_asked_for) {
    open_built_in();
    curves().come();
    EXPECT_TRUE(curves().isVisible());
    curves().close();
    curves().clear();
    curves().come();
    EXPECT_FALSE(curves().isVisible());
    EXPECT_FALSE(settings_.curves_come()) << "the next start keeps to it";
    window_.actions()[ActionId::toggle_plots].trigger();
    EXPECT_TRUE(curves().isVisible());
    EXPECT_TRUE(settings_.curves_come());
}

// The colours that stand out on dark would be weak on white, and the other way round.
TEST(PlotColours, AreThoseOfTheThemeOnWhoseGroundTheyLie) {
    for (const Theme& theme : themes()) {
        PlotView plot;
        QPalette palette;
        palette.setColor(QPalette::Base, theme.base);
        plot.setPalette(palette);
        plot.resize(300, 190);
        plot.set_chart({"", "x", "y", {Curve{"curve", {0, 1}, {0.5, 0.5}}}});
        const QImage drawn = plot.grab().toImage();
        int as_wanted = 0;
        for (int y = 0; y < drawn.height(); ++y)
            as_wanted += drawn.pixelColor(drawn.width() / 2, y) == theme.plot.curves[0] ? 1 : 0;
        EXPECT_GE(as_wanted, 1) << theme.name;
    }
}

TEST(PlotTitles, AreWholeOrEndInAnEllipsisAndNeverOverlap) {
    for (const int width : {220, 250, 300, 480}) {
        PlotView plot;
        plot.resize(width, 190);
        plot.set_chart({"Entropy",
                        "Zeit, seit die Gefäße reißen können (s)",
                        "Wirkstoff jenseits der Enden der Gefäße (%)",
                        {Curve{"Entropie des Risses", {0, 1}, {0, 1}},
                         Curve{"davon erzeugt", {0, 1}, {0, 1}}}});
        const auto titles = plot.titles();
        const QFontMetrics letters = plot.fontMetrics();
        for (std::size_t i = 0; i < titles.size(); ++i) {
            EXPECT_LE(letters.horizontalAdvance(titles[i].text), titles[i].place.width() + 1.0)
                << width << ": " << titles[i].text.toStdString();
            EXPECT_GE(titles[i].place.left(), 0.0);
            EXPECT_LE(titles[i].place.right(), width);
            for (std::size_t k = 0; k < i; ++k) {
                const auto box = [&](const PlotView::Title& title) {
                    return title.curve < 0 && &title != &titles.back()
                               ? QRectF(title.place.topLeft(),
                                        QSizeF(letters.horizontalAdvance(title.text),
                                               title.place.height()))
                               : title.place;
                };
                EXPECT_FALSE(box(titles[i]).intersects(box(titles[k])))
                    << width << ": " << titles[i].text.toStdString();
            }
        }
        QString whole;
        for (const auto& title : titles) whole += title.text + " ";
        EXPECT_FALSE(width >= 250 && whole.contains("…")) << width << ": " << whole.toStdString();
    }
}

// Many things happen at once where a vessel comes off.
TEST(PlotEvents, HaveTheirTextsBesideEachOtherAndWithinTheCurves) {
    for (const int points : {9, 18}) {
        PlotView plot;
        QFont letters = plot.font();
        letters.setPointSize(points);
        plot.setFont(letters);
        plot.resize(300, 190);
        plot.set_chart(
            {"Entropy", "Time (s)", "Entropy (nats)", {Curve{"in all", {0, 10}, {0, 1}}}});
        std::vector<PlotEvent> events;
        for (const double at_s : {1.0, 1.0, 1.1, 2.0, 2.0, 9.9, 9.9})
            for (const char* text : {"cut or torn", "piece off", "bleeding"})
                events.push_back({at_s, text});
        plot.set_events(std::move(events));
        const auto texts = plot.event_texts();
        EXPECT_GE(texts.size(), 3u) << points;
        EXPECT_LT(texts.size(), 21u) << "there is no room for all";
        for (std::size_t i = 0; i < texts.size(); ++i) {
            EXPECT_GE(texts[i].place.height(), plot.fontMetrics().height()) << points;
            EXPECT_LE(texts[i].place.bottom(), plot.height() - 38.0) << "on the axis";
            EXPECT_LE(texts[i].place.right(), plot.width());
            for (std::size_t k = 0; k < i; ++k)
                EXPECT_FALSE(texts[i].place.intersects(texts[k].place))
                    << points << ": " << texts[i].text.toStdString();
        }
        plot.set_events({{2.0, "piece off"}, {20.0, "after the end"}});
        ASSERT_EQ(plot.event_texts().size(), 1u);
        EXPECT_EQ(plot.event_texts()[0].text, "piece off");
    }
}

TEST(ProgressStripTest, names_the_other_jobs) {
    QWidget pictures;
    ProgressStrip strip([] {}, &pictures);
    const auto says = [&](const QString& text) {
        return std::ranges::any_of(strip.findChildren<QLabel*>(),
                                   [&](const QLabel* label) { return label->text() == text; });
    };
    strip.show_others({"Saving a", "Saving b"}, "Writing the report");
    EXPECT_TRUE(says("at the same time: Writing the report; then: Saving a, Saving b"));
    strip.show_others({}, "Writing the report");
    EXPECT_TRUE(says("at the same time: Writing the report"));
}

TEST(ProgressStripTest, says_which_job_its_button_cancels) {
    QWidget pictures;
    ProgressStrip strip([] {}, &pictures);
    for (const QString title : {"Writing the report on A (10:00)", "Opening b"}) {
        strip.start(title);
        EXPECT_TRUE(strip.findChild<QPushButton*>()->toolTip().contains(title));
    }
}

TEST(ProgressStripTest, its_bar_is_of_the_whole_job) {
    QWidget pictures;
    ProgressStrip strip([] {}, &pictures);
    strip.start("Opening");
    const auto shown = [&strip](const JobProgress& progress) {
        strip.update_progress(progress);
        return strip.findChild<QProgressBar*>()->value();
    };
    EXPECT_EQ(shown({"Reading", 0.5, 1, 4}), 125);
    EXPECT_EQ(shown({"Reading", 1.0, 1, 4}), shown({"Meshing", 0.0, 2, 4})) << "it never falls";
    EXPECT_EQ(shown({"Meshing", 1.0, 4, 4}), 1000);
    EXPECT_EQ(shown({"Once more", 0.5, 5, 4}), 900) << "more stages than were announced";
    EXPECT_EQ(shown({"Alone", 0.5, 1, 0}), 500) << "nobody said how many there are";
}

// An empty bar looks as if nothing was done.
TEST(ProgressStripTest, its_bar_is_busy_until_something_is_known) {
    QWidget pictures;
    ProgressStrip strip([] {}, &pictures);
    const auto* bar = strip.findChild<QProgressBar*>();
    strip.start("Writing the report");
    strip.update_progress({});
    EXPECT_EQ(bar->maximum(), 0) << "it moves";
    strip.update_progress({"Reading", 0.0, 1, 4});
    EXPECT_EQ(bar->maximum(), 1000);
    EXPECT_EQ(bar->value(), 0);
}

// In German, at the least width that a whole window has for it.
TEST(ProgressStripTest, cuts_no_words_where_there_is_room_for_them) {
    QWidget pictures;
    pictures.resize(860, 400);
    auto* strip = new ProgressStrip([] {}, &pictures);
    strip->start("Der eingebaute Patient wird geöffnet");
    JobProgress progress;
    progress.stage = "Die Gefäßsysteme werden unterschieden";
    progress.stage_number = 14;
    progress.stage_count = 17;
    strip->update_progress(progress);
    pictures.show();
    for (const auto* label : strip->findChildren<ElidedLabel*>())
        EXPECT_EQ(label->shown(), label->text());
}

// Beside a lesson's panel: the bar takes a third of what the step needs, and yields the rest.
TEST(ProgressStripTest, cuts_no_words_before_its_bar_is_short) {
    QWidget pictures;
    pictures.resize(860, 400);
    auto* strip = new ProgressStrip([] {}, &pictures);
    strip->start("Opening the built-in patient");
    JobProgress progress;
    progress.stage = "Telling the systems apart";
    progress.stage_number = 14;
    progress.stage_count = 17;
    strip->update_progress(progress);
    pictures.show();
    int needed = strip->findChild<QPushButton*>()->sizeHint().width();
    int stage = 0;
    for (const auto* label : strip->findChildren<ElidedLabel*>()) {
        const int hint = label->text().isEmpty() ? 0 : label->sizeHint().width();
        needed += hint;
        if (label->objectName() == "quiet") stage = std::max(stage, hint);
    }
    ASSERT_GT(stage, 120);
    const int margins = 24, gaps = 3 * 14;
    pictures.resize(needed + margins + gaps + stage / 3 + 3, 400);
    QCoreApplication::processEvents();
    for (const auto* label : strip->findChildren<ElidedLabel*>())
        EXPECT_EQ(label->shown(), label->text()) << pictures.width();
}

TEST(ProgressStripTest, a_stage_beside_a_long_title_keeps_room_and_is_cut_at_its_end) {
    QWidget pictures;
    pictures.resize(480, 400);
    auto* strip = new ProgressStrip([] {}, &pictures);
    pictures.show();
    strip->start("Writing the report on the bleeding vessel that one holds (16:10:22)");
    strip->update_progress({"Telling the systems apart once more", 0.5, 4, 4});
    QCoreApplication::processEvents();
    const ElidedLabel* stage = nullptr;
    for (const auto* label : strip->findChildren<ElidedLabel*>())
        if (label->text().startsWith("Telling")) stage = label;
    ASSERT_NE(stage, nullptr);
    EXPECT_GE(stage->width(), 2 * strip->width() / 5);
    EXPECT_TRUE(stage->shown().startsWith("Telling the")) << stage->shown().toStdString();
    EXPECT_TRUE(stage->shown().endsWith("…")) << "it would not need to be cut";
}

// "No gaps" would say that there is none at all.
TEST(EditPanelTest, says_how_many_gaps_the_slider_hides) {
    EditPanel panel;
    const auto listed = [&panel] {
        for (const auto* list : panel.findChildren<QListWidget*>())
            if (list->accessibleName() == "Gaps and doubtful branches")
                return list->item(0)->text().toStdString();
        return std::string();
    };
    EXPECT_EQ(listed(), "none");
    panel.show_bridges({}, {}, 3);
    EXPECT_EQ(listed(), "none; with less confidence: 3");
    panel.show_bridges({"63 %, 4.1 mm"}, {}, 3);
    EXPECT_EQ(listed(), "63 %, 4.1 mm");
}

// One goes down the tree alone, the other up as well: their names and lines tell which.
TEST(EditPanelTest, says_how_far_a_correction_of_a_system_reaches) {
    EditPanel panel;
    auto* tools = panel.findChild<QComboBox*>("EditTool");
    const auto said_of = [&](const char* tool) {
        tools->setCurrentText(tool);
        QString lines;
        for (const auto* label : panel.findChildren<QLabel*>()) lines += label->text() + "\n";
        return lines;
    };
    const QString of_branch = said_of("Set a branch's system");
    EXPECT_EQ(panel.tool(), TreeEditKind::reassign_system);
    EXPECT_TRUE(of_branch.contains("What it hangs on keeps its own")) << of_branch.toStdString();
    const QString of_vessel = said_of("Set a whole vessel's system");
    EXPECT_EQ(panel.tool(), TreeEditKind::seed_system);
    EXPECT_TRUE(of_vessel.contains("towards the root")) << of_vessel.toStdString();
}

}  // namespace
}  // namespace hepatica
