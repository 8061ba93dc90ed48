// SPDX-License-Identifier: GPL-3.0-or-later
// Where the focus goes a panel scrolls, but never from under the mouse.
#include "ui/focus_of_view.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QDialog>
#include <QDockWidget>
#include <QMainWindow>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QTest>
#include <QVBoxLayout>
#include <QWindow>

namespace hepatica {
namespace {

// A panel with more buttons than it has room for.
class FocusInSight : public ::testing::Test {
  protected:
    FocusInSight() {
        auto* column = new QVBoxLayout(content_);
        for (int b = 0; b < 12; ++b) {
            buttons_.push_back(new QPushButton("Pause", content_));
            buttons_.back()->setMinimumHeight(40);
            column->addWidget(buttons_.back());
        }
        scroll_->setWidgetResizable(true);
        scroll_->setWidget(content_);
        auto* dock = new QDockWidget("Panel", &window_);
        dock->setWidget(scroll_);
        window_.setCentralWidget(view_);
        window_.addDockWidget(Qt::RightDockWidgetArea, dock);
        window_.resize(400, 300);
        keep_focus_in_sight(window_, *view_);
        window_.show();
        window_.activateWindow();
    }

    // The first one that is cut off by the foot of the panel.
    QPushButton* half_hidden() {
        for (QPushButton* button : buttons_)
            if (!button->visibleRegion().isEmpty() &&
                button->visibleRegion().boundingRect().height() < button->height())
                return button;
        return nullptr;
    }

    QMainWindow window_;
    QWidget* view_ = new QWidget;
    QScrollArea* scroll_ = new QScrollArea;
    QWidget* content_ = new QWidget;
    std::vector<QPushButton*> buttons_;
};

TEST_F(FocusInSight, a_button_that_is_half_in_sight_is_clicked_where_it_is) {
    ASSERT_TRUE(QTest::qWaitForWindowActive(&window_));
    QPushButton* button = half_hidden();
    ASSERT_NE(button, nullptr);
    int clicks = 0;
    QObject::connect(button, &QPushButton::clicked, &window_, [&clicks] { ++clicks; });
    const QPoint seen = button->visibleRegion().boundingRect().center();
    // As a mouse does, whose release goes to whatever lies there by then.
    QTest::mouseClick(window_.windowHandle(), Qt::LeftButton, {}, button->mapTo(&window_, seen));
    EXPECT_EQ(clicks, 1);
    EXPECT_TRUE(button->hasFocus());
    EXPECT_EQ(scroll_->verticalScrollBar()->value(), 0);
}

TEST_F(FocusInSight, what_gets_the_focus_otherwise_is_scrolled_into_sight) {
    ASSERT_TRUE(QTest::qWaitForWindowActive(&window_));
    buttons_.back()->setFocus();
    EXPECT_GT(scroll_->verticalScrollBar()->value(), 0);
    EXPECT_EQ(buttons_.back()->visibleRegion().boundingRect().height(), buttons_.back()->height());
}

// The button that opened a dialog is hidden before its window is active again: Qt chooses the next
// control, be it in a panel behind another.
TEST_F(FocusInSight, that_comes_back_with_the_window_brings_no_panel_to_the_front) {
    ASSERT_TRUE(QTest::qWaitForWindowActive(&window_));
    auto* behind = window_.findChild<QDockWidget*>();
    auto* other = new QDockWidget("Other", &window_);
    other->setWidget(new QWidget);
    window_.addDockWidget(Qt::RightDockWidgetArea, other);
    window_.tabifyDockWidget(behind, other);
    other->show();
    other->raise();
    ASSERT_TRUE(QTest::qWaitFor([&] { return behind->visibleRegion().isEmpty(); }));
    QDialog dialog(&window_);
    dialog.show();
    QApplication::setActiveWindow(&dialog);
    ASSERT_TRUE(QTest::qWaitFor([&] { return !window_.isActiveWindow(); }));
    buttons_.front()->setFocus();
    dialog.close();
    QApplication::setActiveWindow(&window_);
    ASSERT_TRUE(QTest::qWaitFor([&] { return QApplication::focusWidget() != nullptr; }));
    EXPECT_TRUE(view_->hasFocus());
    EXPECT_TRUE(behind->visibleRegion().isEmpty());
}

}  // namespace
}  // namespace hepatica
