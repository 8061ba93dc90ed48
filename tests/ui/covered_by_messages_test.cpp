// SPDX-License-Identifier: GPL-3.0-or-later
// What a message lies beside instead of upon: the pictures of the library's cases, and the panel of
// the empty view.
#include <QListWidget>

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
    const auto top_of = [&](const QWidget* shown) { return shown->mapTo(&library, QPoint()).y(); };
    const int before = top_of(list);
    library.messages().show_notice("There is a case of this name here already.");
    ASSERT_TRUE(testing::wait_for(
        [&] { return top_of(list) >= top_of(&library.messages()) + library.messages().height(); }));
    EXPECT_GT(library.messages().height(), 0);
    EXPECT_EQ(top_of(&library.messages()), before) << "in the list's place";
    library.messages().dismiss();
    EXPECT_TRUE(testing::wait_for([&] { return top_of(list) == before; }));
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
