// SPDX-License-Identifier: GPL-3.0-or-later
// Enter presses the focused button of the window as Space does, and means what it meant elsewhere.
#include "ui/enter_key.h"

#include <QDialog>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QPushButton>
#include <QTimer>
#include <QToolButton>
#include <QVBoxLayout>

#include "tests/ui/fake_window_test.h"

namespace hepatica::testing {
namespace {

// The filter is that of the main window, and works in all windows of the program.
class EnterKeyTest : public FakeWindowTest {
  protected:
    // Of a button's clicks in this window, whichever widget gets the key.
    int clicks_after(QWidget& window, QWidget& focused, Qt::Key key,
                     Qt::KeyboardModifiers modifiers = {}) {
        window.show();
        window.activateWindow();
        EXPECT_TRUE(QTest::qWaitForWindowActive(&window));
        focused.setFocus();
        EXPECT_TRUE(focused.hasFocus());
        clicks_ = 0;
        QTest::keyClick(&focused, key, modifiers);
        return clicks_;
    }
    void count(QAbstractButton& button) {
        QObject::connect(&button, &QAbstractButton::clicked, [this] { ++clicks_; });
    }

    int clicks_ = 0;
};

TEST_F(EnterKeyTest, PressesTheFocusedButtonOnce) {
    QWidget panel;
    QVBoxLayout column(&panel);
    QPushButton push("Pause");
    QToolButton tool;
    for (QAbstractButton* button :
         {static_cast<QAbstractButton*>(&push), static_cast<QAbstractButton*>(&tool)}) {
        button->setFocusPolicy(Qt::StrongFocus);
        column.addWidget(button);
        count(*button);
    }
    for (QWidget* button : {static_cast<QWidget*>(&push), static_cast<QWidget*>(&tool)}) {
        EXPECT_EQ(clicks_after(panel, *button, Qt::Key_Space), 1);
        EXPECT_EQ(clicks_after(panel, *button, Qt::Key_Return), 1);
        EXPECT_EQ(clicks_after(panel, *button, Qt::Key_Enter, Qt::KeypadModifier), 1);
        EXPECT_EQ(clicks_after(panel, *button, Qt::Key_Return, Qt::ControlModifier), 0);
        QKeyEvent held(QEvent::KeyPress, Qt::Key_Return, Qt::NoModifier, "\r", true);
        QApplication::sendEvent(button, &held);
        EXPECT_EQ(clicks_, 0) << "a key that is held down presses once";
    }
}

TEST_F(EnterKeyTest, PressesNoButtonFromAFieldOrAList) {
    QWidget panel;
    QVBoxLayout column(&panel);
    QPushButton push("Pause");
    QLineEdit field;
    QListWidget list;
    list.addItem("a row");
    for (QWidget* widget : {static_cast<QWidget*>(&push), static_cast<QWidget*>(&field),
                            static_cast<QWidget*>(&list)})
        column.addWidget(widget);
    count(push);
    int entered = 0, activated = 0;
    QObject::connect(&field, &QLineEdit::returnPressed, [&] { ++entered; });
    QObject::connect(&list, &QListWidget::itemActivated, [&] { ++activated; });
    EXPECT_EQ(clicks_after(panel, field, Qt::Key_Return), 0);
    EXPECT_EQ(entered, 1);
    list.setCurrentRow(0);
    EXPECT_EQ(clicks_after(panel, list, Qt::Key_Return), 0);
    EXPECT_EQ(activated, 1);
}

// Not the dialog's default, which the focus has left.
TEST_F(EnterKeyTest, PressesTheFocusedButtonOfADialog) {
    QDialog dialog;
    QVBoxLayout column(&dialog);
    QPushButton close("Close"), other("Other");
    other.setAutoDefault(false);
    close.setDefault(true);
    column.addWidget(&close);
    column.addWidget(&other);
    count(other);
    QObject::connect(&close, &QPushButton::clicked, &dialog, &QDialog::accept);
    EXPECT_EQ(clicks_after(dialog, other, Qt::Key_Return), 1);
    EXPECT_TRUE(dialog.isVisible());
}

TEST_F(EnterKeyTest, OpensTheMenuOfAButtonThatIsNothingElse) {
    QWidget panel;
    QVBoxLayout column(&panel);
    QToolButton tool;
    QMenu menu;
    menu.addAction("an entry");
    tool.setMenu(&menu);
    tool.setPopupMode(QToolButton::InstantPopup);
    tool.setFocusPolicy(Qt::StrongFocus);
    column.addWidget(&tool);
    bool shown = false;
    // The menu has an event loop of its own until it is closed.
    QObject::connect(&menu, &QMenu::aboutToShow, [&] {
        shown = true;
        QTimer::singleShot(0, &menu, &QMenu::close);
    });
    clicks_after(panel, tool, Qt::Key_Return);
    EXPECT_TRUE(shown);
}

}  // namespace
}  // namespace hepatica::testing
