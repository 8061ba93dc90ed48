// SPDX-License-Identifier: GPL-3.0-or-later
// The guide inside the program: its pages are there, lead to each other, and name nothing that the
// menus do not have.
#include "ui/guide.h"

#include <QFile>
#include <QMenu>
#include <QMenuBar>
#include <QRegularExpression>
#include <QTextBlock>
#include <QTextBrowser>
#include <set>
#include <string>

#include "core/base/program_files.h"
#include "tests/ui/fake_window_test.h"
#include "tests/ui/speaks.h"
#include "ui/paths.h"

namespace hepatica {
namespace {

constexpr const char* english = "guide";
constexpr const char* german = "guide/de";

std::set<QString> pages(const char* folder) {
    std::set<QString> names;
    for (const auto& entry : std::filesystem::directory_iterator(asset(folder)))
        if (entry.path().extension() == ".md") names.insert(to_text(entry.path().filename()));
    return names;
}

QString text_of(const char* folder, const QString& page) {
    QFile file(to_text(asset(folder) / page.toStdString()));
    EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << page.toStdString();
    return QString::fromUtf8(file.readAll());
}

std::vector<QString> all_matches(const QString& pattern, const QString& text) {
    std::vector<QString> found;
    auto matches = QRegularExpression(pattern).globalMatch(text);
    while (matches.hasNext()) found.push_back(matches.next().captured(1));
    return found;
}

int count_of(const QString& pattern, const QString& text) {
    return static_cast<int>(all_matches("(" + pattern + ")", text).size());
}

class GuidePages : public testing::FakeWindowTest {
  protected:
    void expect_menu_entries_of(const char* folder) {
        const std::set<QString> entries = menu_entries();
        int named = 0;
        for (const QString& page : pages(folder))
            for (const QString& entry :
                 all_matches(R"(\*(\p{Lu}\p{Ll}+ > [^*]+)\*)", text_of(folder, page))) {
                ++named;
                EXPECT_TRUE(entries.contains(entry))
                    << page.toStdString() << " names " << entry.toStdString();
            }
        EXPECT_GT(named, 8);
    }

    // As a person reads them, "Menu > Entry".
    std::set<QString> menu_entries() {
        std::set<QString> entries;
        const auto plain = [](QString text) {
            return text.remove('&').remove(QChar(0x2026)).trimmed();
        };
        for (const QAction* menu : window_.menuBar()->actions())
            for (const QAction* entry : menu->menu()->actions())
                entries.insert(plain(menu->text()) + " > " + plain(entry->text()));
        return entries;
    }
};

class GermanGuide : testing::Speaks, public GuidePages {
  protected:
    GermanGuide() : Speaks("de") {}
};

TEST(GuideFiles, EveryLinkAndPictureIsThereAndEveryPageIsReached) {
    for (const char* folder : {english, german}) {
        std::set<QString> reached{"index.md"};
        for (const QString& page : pages(folder))
            for (const QString& link : all_matches(R"(\]\(([^)]+)\))", text_of(folder, page))) {
                EXPECT_TRUE(std::filesystem::exists(asset(folder) / link.toStdString()))
                    << page.toStdString() << " leads to " << link.toStdString();
                reached.insert(link);
            }
        for (const QString& page : pages(folder))
            EXPECT_TRUE(reached.contains(page)) << page.toStdString() << " is reached by no link";
    }
}

// A page that is changed in one language is changed in the other.
TEST(GuideFiles, TranslatedPagesHaveWhatTheEnglishOnesHave) {
    ASSERT_EQ(pages(german), pages(english));
    for (const QString& page : pages(english)) {
        const QString there = text_of(english, page), here = text_of(german, page);
        for (const char* part : {"\n\n", "\n#", "\n\\|", "\n\\* ", "\n\\d\\. ", "!\\[", "\\]\\(",
                                 "\\*\\p{Lu}\\p{Ll}+ > "})
            EXPECT_EQ(count_of(part, here), count_of(part, there))
                << page.toStdString() << ": " << part;
    }
}

TEST_F(GuidePages, NameNoMenuEntryThatIsNotThere) {
    expect_menu_entries_of(english);
}

TEST_F(GermanGuide, NamesNoMenuEntryThatIsNotThere) {
    expect_menu_entries_of(german);
}

TEST_F(GermanGuide, OpensInGerman) {
    window_.actions()[ActionId::guide].trigger();
    auto* guide = static_cast<Guide*>(window_.findChild<QDialog*>("guide"));
    ASSERT_NE(guide, nullptr);
    EXPECT_TRUE(guide->browser().toPlainText().startsWith("Anleitung"));
}

TEST_F(GuidePages, OpenFromTheMenuAndLeadToEachOtherAndBack) {
    QTest::keyClick(&window_, Qt::Key_F1, Qt::ShiftModifier);
    auto* guide = window_.findChild<QDialog*>("guide");
    ASSERT_NE(guide, nullptr);
    QTextBrowser& browser = static_cast<Guide*>(guide)->browser();
    ASSERT_TRUE(testing::wait_for([&] { return guide->isVisible(); }));
    EXPECT_TRUE(browser.toPlainText().startsWith("Guide"));
    for (const QString& page : pages(english)) {
        static_cast<Guide*>(guide)->show_page(page);
        const QString title = text_of(english, page).section('\n', 0, 0).mid(2);
        EXPECT_TRUE(browser.toPlainText().startsWith(title)) << page.toStdString();
    }
    static_cast<Guide*>(guide)->show_page("index.md");
    // The first link, by keys alone.
    QTest::keyClick(&browser, Qt::Key_Tab);
    QTest::keyClick(&browser, Qt::Key_Return);
    EXPECT_TRUE(browser.toPlainText().startsWith("The first five minutes"));
    browser.backward();
    EXPECT_TRUE(browser.toPlainText().startsWith("Guide"));
    window_.actions()[ActionId::guide].trigger();  // one at a time
    EXPECT_EQ(window_.findChildren<QDialog*>("guide").size(), 1);
}

TEST_F(GuidePages, KeysAndMouseAreShownInOneWindowHoweverOftenTheyAreAskedFor) {
    const auto sheets = [this] {
        QList<QDialog*> shown;
        for (QDialog* dialog : window_.findChildren<QDialog*>())
            if (dialog->windowTitle() == "Keys and mouse" && dialog->isVisible()) shown << dialog;
        return shown;
    };
    QTest::keyClick(&window_, Qt::Key_F1);
    QTest::keyClick(&window_, Qt::Key_F1);
    ASSERT_EQ(sheets().size(), 1);
    sheets().first()->reject();
    EXPECT_TRUE(sheets().isEmpty());
    QTest::keyClick(&window_, Qt::Key_F1);
    EXPECT_EQ(sheets().size(), 1) << "it comes again";
}

}  // namespace
}  // namespace hepatica
