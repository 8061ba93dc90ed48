// SPDX-License-Identifier: GPL-3.0-or-later
// What a message lies beside instead of upon: the pictures of the library's cases, and the panel of
// the empty view.
#include <QListWidget>
#include <QToolButton>

#include "tests/ui/fake_window_test.h"
#include "ui/library_dialog.h"
#include "ui/message_bar.h"
#include "ui/welcome.h"

namespace hepatica {
namespace {

class CoveredByMessages : public testing::FakeWindowTest {};

TEST_F(CoveredByMessages, ThePicturesOfCasesAreNot) {
    LibraryDialog& library = window_.library();
    library.show();
    ASSERT_TRUE(testing::wait_for([&] { return library.isVisible(); }));
    auto* list = library.findChild<QListWidget*>("library");
    ASSERT_TRUE(testing::wait_for([&] { return !library.busy(); }));
    const QRect before = list->geometry();
    ASSERT_GT(before.height(), 0);
    MessageBar& messages = library.messages();
    for (const bool offers : {false, true}) {
        const QString text = "There is a case of this name here already.";
        offers ? messages.show_notice(text, "Keep both", [] {}) : messages.show_notice(text);
        ASSERT_TRUE(testing::wait_for([&] { return messages.covered() > 0; }));
        QApplication::sendPostedEvents();
        EXPECT_EQ(list->geometry(), before) << "nothing moves under the mouse";
        EXPECT_GE(messages.y(), list->geometry().bottom());
        messages.dismiss();
        QApplication::sendPostedEvents();
        EXPECT_EQ(list->geometry(), before);
    }
}

// One that is opened covers no picture either.
TEST_F(CoveredByMessages, ThePicturesOfCasesAreNotByOneOfManyLines) {
    LibraryDialog& library = window_.library();
    library.show();
    ASSERT_TRUE(testing::wait_for([&] { return library.isVisible() && !library.busy(); }));
    auto* list = library.findChild<QListWidget*>("library");
    const int top = list->y();
    MessageBar& messages = library.messages();
    messages.show_notice(QString("A line.\n").repeated(6) + "The last one.");
    messages.findChild<QToolButton*>("moreOfMessage")->click();
    ASSERT_TRUE(testing::wait_for(
        [&] { return messages.open() && messages.y() >= list->geometry().bottom(); }));
    EXPECT_EQ(list->y(), top);
}

// The lower the view, the nearer its panel is to the message.
TEST_F(CoveredByMessages, ThePanelOfTheEmptyViewIsNot) {
    QWidget view;
    view.resize(900, 700);
    Welcome panel(
        window_.actions(), [] {}, &view);
    const int middle = panel.y();
    EXPECT_GT(middle, 30);
    panel.keep_clear(30);
    EXPECT_EQ(panel.y(), middle) << "it lies below the message anyway";
    panel.keep_clear(middle + 12);
    EXPECT_EQ(panel.y(), middle + 12);
    panel.keep_clear(0);
    EXPECT_EQ(panel.y(), middle);
}

}  // namespace
}  // namespace hepatica
