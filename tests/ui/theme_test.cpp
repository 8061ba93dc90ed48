// SPDX-License-Identifier: GPL-3.0-or-later
// The looks of the window: what is written can be read in each of them, and the one that was chosen
// stays.
#include "ui/theme.h"

#include <QApplication>
#include <QCheckBox>
#include <QMainWindow>
#include <QPushButton>
#include <QStyle>
#include <QTableWidget>
#include <QToolBar>
#include <QToolButton>
#include <cmath>
#include <set>
#include <vector>

#include "tests/ui/fake_window_test.h"
#include "ui/colours.h"

namespace hepatica::testing {
namespace {

// Relative luminance and contrast ratio as WCAG 2.1 defines them.
double luminance(const QColor& colour) {
    const auto linear = [](double channel) {
        return channel <= 0.03928 ? channel / 12.92 : std::pow((channel + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(colour.redF()) + 0.7152 * linear(colour.greenF()) +
           0.0722 * linear(colour.blueF());
}
double contrast(const QColor& a, const QColor& b) {
    const double one = luminance(a) + 0.05, other = luminance(b) + 0.05;
    return std::max(one, other) / std::min(one, other);
}

TEST(Themes, KeepTextReadable) {
    for (const Theme& theme : themes()) {
        // Level AA asks for 4.5 to 1, level AAA for 7 to 1.
        const double least = std::string_view(theme.name) == "high-contrast" ? 7.0 : 4.5;
        const std::initializer_list<std::pair<QColor, QColor>> pairs{
            {theme.text, theme.window},
            {theme.text, theme.base},
            {theme.text, theme.bar},
            {theme.text, theme.button},
            {theme.text, theme.button_hover},
            {theme.quiet, theme.window},
            {theme.quiet, theme.bar},
            {theme.quiet, theme.base},
            {theme.title, theme.base},
            {theme.accent_text, theme.accent},
            {theme.message_text, theme.failure},
            {theme.message_text, theme.notice},
            {theme.problem, theme.window},
            {theme.link, theme.window},
            {qcolor_of(theme.view.text), qcolor_of(theme.view.top)},
            {qcolor_of(theme.view.text), qcolor_of(theme.view.bottom)},
            {qcolor_of(theme.view.faint_text), qcolor_of(theme.view.top)},
            {qcolor_of(theme.view.faint_text), qcolor_of(theme.view.bottom)}};
        int number = 0;
        for (const auto& [text, ground] : pairs)
            EXPECT_GE(contrast(text, ground), least)
                << theme.name << ", pair " << number++ << ": " << text.name().toStdString()
                << " on " << ground.name().toStdString();
    }
}

// WCAG 2.1 asks for 3 to 1 of shapes, and for 4.5 to 1 of words, as the names of curves are.
TEST(Themes, KeepPlotsAndToolsInSight) {
    for (const Theme& theme : themes()) {
        const PlotColours& plot = theme.plot;
        std::vector<QColor> written(plot.curves.begin(), plot.curves.end());
        written.insert(written.end(), {plot.event, plot.time});
        for (const QColor& colour : written)
            EXPECT_GE(contrast(colour, theme.base), 4.5)
                << theme.name << ": " << colour.name().toStdString();
        EXPECT_EQ(&plot_colours_on(theme.base), &plot) << theme.name;
        const QColor tool = qcolor_of(theme.view.tool);
        for (const Colour& ground : {theme.view.top, theme.view.bottom})
            EXPECT_GE(contrast(tool, qcolor_of(ground)), 3.0) << theme.name << ": tool";
    }
}

// Else the text of a column touches that of the next.
TEST(Themes, LeaveRoomBesideTheTextOfATable) {
    for (const Theme& theme : themes()) {
        apply_theme(*qApp, theme);
        QTableWidget table(1, 2);
        table.setItem(0, 0, new QTableWidgetItem("Hold a bleeding vessel"));
        table.resizeColumnToContents(0);
        const int text = table.fontMetrics().horizontalAdvance(table.item(0, 0)->text());
        EXPECT_GE(table.columnWidth(0), text + 10) << theme.name;
    }
    apply_theme(*qApp);
}

// Words that cannot be chosen would else be written twice, one of them aside in white.
TEST(Themes, WriteDisabledWordsOnce) {
    apply_theme(*qApp);
    EXPECT_EQ(QApplication::style()->styleHint(QStyle::SH_EtchDisabledText), 0);
}

TEST(Themes, AreFoundByNameAndBeginDark) {
    EXPECT_STREQ(theme_named("light").name, "light");
    EXPECT_STREQ(theme_named("no such theme").name, "dark");
    EXPECT_STREQ(theme_named("").name, "dark");
}

class ChosenTheme : public FakeWindowTest {
  protected:
    ~ChosenTheme() override { apply_theme(*qApp); }
};

TEST_F(ChosenTheme, ColoursWindowAndViewAndStays) {
    open_built_in();
    EXPECT_TRUE(window_.actions()[ActionId::theme_dark].isChecked());
    const QColor dark = window_.view().drawn().pixelColor(3, 3);
    window_.actions()[ActionId::theme_light].trigger();
    EXPECT_FALSE(window_.actions()[ActionId::theme_dark].isChecked());
    EXPECT_EQ(settings_.theme(), "light");
    EXPECT_EQ(QApplication::palette().color(QPalette::Window), themes()[1].window);
    paint();
    const QColor light = window_.view().drawn().pixelColor(3, 3);
    EXPECT_LT(luminance(dark), 0.1);
    EXPECT_GT(luminance(light), 0.5);

    MainWindow next(settings_, {});
    EXPECT_TRUE(next.actions()[ActionId::theme_light].isChecked());
}

// Of pixels, between whose colours in the two pictures there are at least 3 to 1, as WCAG 2.2 asks
// of what shows the focus.
int distinct_pixels(const QImage& one, const QImage& other) {
    int distinct = 0;
    for (int y = 0; y < one.height(); ++y)
        for (int x = 0; x < one.width(); ++x)
            distinct += contrast(one.pixelColor(x, y), other.pixelColor(x, y)) >= 3.0 ? 1 : 0;
    return distinct;
}

// Where the keys go is to be seen, whatever takes them.
TEST_F(ChosenTheme, ShowsEveryStopOfTheTabKey) {
    QApplication::setCursorFlashTime(0);
    open_built_in();
    window_.actions()[ActionId::toggle_branches].trigger();
    // Else Tab goes through the cells of a table and never leaves it.
    for (QTableWidget* table : window_.findChildren<QTableWidget*>())
        table->setTabKeyNavigation(false);
    for (const ActionId theme :
         {ActionId::theme_dark, ActionId::theme_light, ActionId::theme_high_contrast}) {
        window_.actions()[theme].trigger();
        window_.view().setFocus(Qt::TabFocusReason);
        const auto around = [this](const QWidget& stop, int margin) {
            QCoreApplication::processEvents();
            const QRect place(stop.mapTo(&window_, QPoint()), stop.size());
            return window_.grab(place.adjusted(-margin, -margin, margin, margin)).toImage();
        };
        std::set<QWidget*> stops;
        for (QWidget* stop = QApplication::focusWidget(); stops.insert(stop).second;
             stop = QApplication::focusWidget()) {
            const QImage with = around(*stop, 4);
            QTest::keyClick(stop, Qt::Key_Tab);
            ASSERT_NE(QApplication::focusWidget(), nullptr);
            if (stop == &window_.view()) continue;  // its picture changes by itself, see below
            // Three pixels along nearly half of the way around: the rest may lie beyond a panel's
            // edge, or upon what is of a similar colour.
            EXPECT_GT(distinct_pixels(with, around(*stop, 4)),
                      2.5 * (stop->width() + stop->height()))
                << stop->metaObject()->className() << " " << stop->objectName().toStdString() << " "
                << stop->accessibleName().toStdString();
        }
        EXPECT_GT(stops.size(), 15u);
    }
    QApplication::setCursorFlashTime(1000);
}

TEST_F(ChosenTheme, FramesTheFocusedButtonByThreePixelsThatStandOut) {
    for (const Theme& theme : themes()) {
        apply_theme(*qApp, theme);
        QWidget window;
        QPushButton plain("Pause", &window), chosen("Play", &window);
        chosen.setDefault(true);
        plain.setGeometry(20, 20, 100, 30);
        chosen.setGeometry(20, 80, 100, 30);
        window.show();
        window.activateWindow();
        ASSERT_TRUE(QTest::qWaitForWindowActive(&window));
        for (QPushButton* button : {&plain, &chosen}) {
            (button == &plain ? chosen : plain).setFocus();
            QCoreApplication::processEvents();
            const QImage without = window.grab().toImage();
            button->setFocus();
            QCoreApplication::processEvents();
            const QImage with = window.grab().toImage();
            const int middle_y = button->geometry().center().y();
            const int middle_x = button->geometry().center().x();
            const auto differs = [&](int x, int y) {
                return contrast(with.pixelColor(x, y), without.pixelColor(x, y)) >= 3.0;
            };
            for (int k = 1; k <= 3; ++k) {
                EXPECT_TRUE(differs(button->x() - k, middle_y)) << theme.name << " left " << k;
                EXPECT_TRUE(differs(middle_x, button->y() - k)) << theme.name << " top " << k;
            }
        }
        for (const QColor& ground : {theme.window, theme.base, theme.bar})
            EXPECT_GE(contrast(theme.accent_border, ground), 3.0) << theme.name;
    }
}

// What may be written can be read, and is not taken for what was.
TEST_F(ChosenTheme, SaysWhatMayBeWritten) {
    for (const ActionId theme :
         {ActionId::theme_dark, ActionId::theme_light, ActionId::theme_high_contrast}) {
        window_.actions()[theme].trigger();
        const QPalette palette = QApplication::palette();
        const QColor hint = palette.color(QPalette::PlaceholderText);
        EXPECT_GE(contrast(hint, palette.color(QPalette::Base)), 4.5) << hint.name().toStdString();
        EXPECT_NE(hint, palette.color(QPalette::Text));
    }
}

TEST_F(ChosenTheme, TicksWhatIsChecked) {
    for (const Theme& theme : themes()) {
        apply_theme(*qApp, theme);
        QCheckBox box("word");
        box.setChecked(true);
        box.resize(box.sizeHint());
        const QImage ticked = box.grab().toImage();
        // Of the tick and of what it stands on.
        int tick = 0, ground = 0;
        for (int y = 0; y < ticked.height(); ++y)
            for (int x = 0; x < 18; ++x) {
                tick += ticked.pixelColor(x, y) == theme.accent_text ? 1 : 0;
                ground += ticked.pixelColor(x, y) == theme.accent ? 1 : 0;
            }
        EXPECT_GT(tick, 3) << theme.name;
        EXPECT_GT(ground, 40) << theme.name;
        EXPECT_GE(contrast(theme.accent_text, theme.accent), 4.5) << theme.name;
    }
}

// Else nobody finds the tools that have no room. The theme changes while the bar is shown.
TEST_F(ChosenTheme, ShowsThatABarHasMoreTools) {
    QMainWindow window;
    auto* bar = new QToolBar(&window);
    for (int i = 0; i < 20; ++i) bar->addAction("a tool");
    window.addToolBar(bar);
    window.resize(300, 100);
    window.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&window));
    auto* more = bar->findChild<QToolButton*>("qt_toolbar_ext_button");
    ASSERT_TRUE(more != nullptr && more->isVisible());
    for (const Theme& theme : themes()) {
        apply_theme(*qApp, theme);
        const QImage shown = more->grab().toImage();
        int seen = 0;
        for (int y = 0; y < shown.height(); ++y)
            for (int x = 0; x < shown.width(); ++x)
                seen += contrast(shown.pixelColor(x, y), theme.bar) >= 3.0 ? 1 : 0;
        EXPECT_GT(seen, 10) << theme.name;
    }
}

TEST_F(ChosenTheme, LeavesAnUntickedBoxOfASelectedRowEmpty) {
    for (const Theme& theme : themes()) {
        apply_theme(*qApp, theme);
        QTableWidget table(1, 1);
        auto* item = new QTableWidgetItem;
        item->setCheckState(Qt::Unchecked);
        table.setItem(0, 0, item);
        table.selectRow(0);
        const QImage row = table.viewport()->grab(table.visualItemRect(item)).toImage();
        int filled = 0;
        for (int y = 2; y < row.height() - 2; ++y)
            for (int x = 2; x < 22; ++x) filled += row.pixelColor(x, y) == theme.base ? 1 : 0;
        EXPECT_LT(filled, 60) << theme.name << ": at most its outline";
    }
}

}  // namespace
}  // namespace hepatica::testing
