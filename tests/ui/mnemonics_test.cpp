// SPDX-License-Identifier: GPL-3.0-or-later
// Keys with Alt: each menu and button in sight has one of its own, in every language.
#include <QAbstractButton>
#include <QLabel>
#include <QMap>
#include <QMenu>
#include <QMenuBar>
#include <QRegularExpression>

#include "tests/ui/fake_window_test.h"
#include "tests/ui/speaks.h"
#include "ui/lesson_dock.h"
#include "ui/review_dock.h"

namespace hepatica::testing {
namespace {

QString mnemonic_of(QString text) {
    static const QRegularExpression key("&(\\w)");
    return key.match(text.remove("&&")).captured(1).toLower();
}

class Mnemonics : Speaks, public FakeWindowTest, public ::testing::WithParamInterface<const char*> {
  protected:
    Mnemonics() : Speaks(GetParam()) {}

    static void expect_no_doubles(const QStringList& texts) {
        QMap<QString, QString> taken;
        for (const QString& text : texts) {
            const QString key = mnemonic_of(text);
            if (key.isEmpty()) continue;
            EXPECT_FALSE(taken.contains(key))
                << text.toStdString() << " and " << taken[key].toStdString();
            taken[key] = text;
        }
    }
};

TEST_P(Mnemonics, OfMenusAndButtonsInSightAreUnique) {
    open_built_in();
    window_.lessons().show();
    window_.review().show();
    QStringList texts;
    for (const QAction* menu : window_.menuBar()->actions()) texts << menu->text();
    // What a dock may show stands for what it shows at its fullest.
    for (const QAbstractButton* button : window_.findChildren<QAbstractButton*>())
        if (button->window() == &window_) texts << button->text();
    for (const QLabel* label : window_.findChildren<QLabel*>())
        if (label->buddy() != nullptr && label->window() == &window_) texts << label->text();
    EXPECT_GT(texts.size(), 15);
    expect_no_doubles(texts);
}

TEST_P(Mnemonics, WithinAMenuAreUnique) {
    for (const QAction* menu : window_.menuBar()->actions()) {
        QStringList texts;
        for (const QAction* entry : menu->menu()->actions()) texts << entry->text();
        expect_no_doubles(texts);
    }
}

INSTANTIATE_TEST_SUITE_P(Languages, Mnemonics, ::testing::Values("en", "de"));

}  // namespace
}  // namespace hepatica::testing
