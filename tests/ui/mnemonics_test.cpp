// SPDX-License-Identifier: GPL-3.0-or-later
// Keys with Alt, in every language: each menu has one, each of its entries has one or a shortcut,
// and none is there twice, nor among the buttons in sight.
#include <QAbstractButton>
#include <QLabel>
#include <QMap>
#include <QMenu>
#include <QMenuBar>
#include <QRegularExpression>
#include <algorithm>

#include "tests/ui/fake_window_test.h"
#include "tests/ui/speaks.h"
#include "ui/lesson_dock.h"
#include "ui/review_dock.h"

namespace hepatica::testing {
namespace {

QString mnemonic_of(QString text) {
    static const QRegularExpression key("&(\\w)", QRegularExpression::UseUnicodePropertiesOption);
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
    // Of this menu and those in it; returns how many entries have no mnemonic.
    static int expect_keys_in(QMenu& menu) {
        emit menu.aboutToShow();  // some are filled then
        QStringList texts;
        int without = 0;
        for (const QAction* entry : menu.actions()) {
            if (entry->isSeparator()) continue;
            texts << entry->text();
            const bool has_none = mnemonic_of(entry->text()).isEmpty();
            EXPECT_FALSE(has_none && entry->shortcut().isEmpty()) << entry->text().toStdString();
            without += has_none ? 1 : 0;
            if (entry->menu() != nullptr) without += expect_keys_in(*entry->menu());
        }
        EXPECT_FALSE(texts.empty()) << menu.title().toStdString();
        expect_no_doubles(texts);
        return without;
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
    const auto with = std::ranges::count_if(
        texts, [](const QString& text) { return !mnemonic_of(text).isEmpty(); });
    EXPECT_GE(with, 14) << "six menus, and the buttons of lessons and reviews";
    expect_no_doubles(texts);
}

// Of View there are more entries than letters in them: some have their shortcut alone.
TEST_P(Mnemonics, WithinAMenuAreUniqueAndEveryEntryHasAKey) {
    int without = 0;
    for (const QAction* menu : window_.menuBar()->actions()) {
        EXPECT_FALSE(mnemonic_of(menu->text()).isEmpty()) << menu->text().toStdString();
        without += expect_keys_in(*menu->menu());
    }
    EXPECT_LE(without, 5);
}

INSTANTIATE_TEST_SUITE_P(Languages, Mnemonics, ::testing::Values("en", "de"));

}  // namespace
}  // namespace hepatica::testing
