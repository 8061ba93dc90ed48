// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/elided_status_bar.h"

#include <gtest/gtest.h>

#include <QHelpEvent>
#include <QLabel>
#include <QToolTip>

#include "tests/ui/fake_window_test.h"
#include "ui/plain_text.h"

namespace hepatica {
namespace {

const QString long_message = QString("a long sentence about vessels ").repeated(20).trimmed();

class StatusBarOfTheWindow : public testing::FakeWindowTest {};

TEST(ElidedStatusBarAlone, EndsALongMessageBeforeTheFigures) {
    ElidedStatusBar bar;
    auto* figure = new QLabel("step 3.0 ms");
    bar.addPermanentWidget(figure);
    bar.resize(400, 24);
    bar.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&bar, testing::patience_ms));
    bar.showMessage("short");
    EXPECT_EQ(bar.shown(), "short");
    bar.showMessage(long_message);
    EXPECT_EQ(bar.currentMessage(), long_message);
    EXPECT_TRUE(bar.shown().endsWith("…")) << bar.shown().toStdString();
    EXPECT_LT(bar.fontMetrics().horizontalAdvance(bar.shown()), figure->x());
}

// Such as the renderer's name, which nobody needs while a hint is to be read.
TEST(ElidedStatusBarAlone, FiguresThatGiveWayLeaveTheirRoomToAMessage) {
    ElidedStatusBar bar;
    auto* recording = new QLabel("Recording");
    auto* picture = new QLabel("picture 10 ms");
    auto* renderer = new QLabel(QString("renderer ").repeated(20));
    for (QLabel* figure : {renderer, picture, recording}) bar.addPermanentWidget(figure);
    bar.set_giving_way({picture, renderer});
    const QString message = "Record the play from now on, and end that";
    const int needed = bar.fontMetrics().horizontalAdvance(message);
    bar.resize(2 * needed + recording->sizeHint().width() + picture->sizeHint().width(), 24);
    ASSERT_GT(renderer->sizeHint().width(), needed) << "with it the message would be cut";
    bar.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&bar, testing::patience_ms));
    EXPECT_FALSE(renderer->isHidden());
    const int place = recording->x();
    bar.showMessage(message);
    QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest);
    EXPECT_EQ(recording->x(), place) << "what stays does not move";
    EXPECT_TRUE(renderer->isHidden());
    EXPECT_FALSE(picture->isHidden()) << "there is room for it";
    EXPECT_FALSE(recording->isHidden());
    EXPECT_EQ(bar.shown(), message);
    renderer->setText("short");
    recording->setText("Rec.");
    QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest);
    EXPECT_TRUE(renderer->isHidden()) << "a figure that changes comes with the next message";
    bar.showMessage(long_message);
    EXPECT_TRUE(picture->isHidden());
    EXPECT_FALSE(recording->isHidden()) << "it gives way to nothing";
    bar.clearMessage();
    EXPECT_FALSE(picture->isHidden());
    EXPECT_FALSE(renderer->isHidden());
}

TEST_F(StatusBarOfTheWindow, LetsTheRenderersNameGiveWay) {
    auto* renderer = window_.statusBar()->findChild<QLabel*>("renderer");
    ASSERT_NE(renderer, nullptr);
    EXPECT_FALSE(renderer->isHidden());
    window_.statusBar()->showMessage(long_message);
    EXPECT_TRUE(renderer->isHidden());
    window_.statusBar()->clearMessage();
    EXPECT_FALSE(renderer->isHidden());
}

TEST_F(StatusBarOfTheWindow, ShowsAMessageThatIsCutAsAWholeInItsTooltip) {
    auto* bar = dynamic_cast<ElidedStatusBar*>(window_.statusBar());
    ASSERT_NE(bar, nullptr);
    bar->showMessage(long_message);
    ASSERT_TRUE(bar->shown().endsWith("…"));
    const QPoint place = bar->rect().center();
    QHelpEvent help(QEvent::ToolTip, place, bar->mapToGlobal(place));
    QApplication::sendEvent(bar, &help);
    EXPECT_EQ(QToolTip::text(), as_plain(long_message));
    QToolTip::hideText();
}

}  // namespace
}  // namespace hepatica
