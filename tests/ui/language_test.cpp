// SPDX-License-Identifier: GPL-3.0-or-later
// The window in another language: every word of it, numbers, and how a language is chosen.
#include "ui/language.h"

#include <QAction>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QProcess>
#include <QPushButton>
#include <QRegularExpression>
#include <QScreen>
#include <QToolBar>
#include <clocale>
#include <map>
#include <set>

#include "core/lesson/lesson_file.h"
#include "core/lesson/lesson_gaps.h"
#include "core/lesson/lesson_writer.h"
#include "tests/ui/fake_window_test.h"
#include "tests/ui/speaks.h"
#include "tests/ui/translations.h"
#include "ui/actions.h"
#include "ui/core_words.h"
#include "ui/decimal_spin_box.h"
#include "ui/lesson_editor/lesson_editor.h"
#include "ui/lesson_editor/new_parts.h"
#include "ui/message_bar.h"
#include "ui/results_dialog.h"
#include "ui/words.h"

namespace hepatica::testing {
namespace {

class GermanWindow : Speaks, public FakeWindowTest {
  protected:
    GermanWindow() : Speaks("de") {}
};

using LanguageChoice = FakeWindowTest;

// "%1", "%L2" and "%n" of a text, a number in the language's form counting as any.
std::multiset<QString> places_in(const QString& text) {
    static const QRegularExpression place("%L?(\\d|n)");
    std::multiset<QString> found;
    for (auto match = place.globalMatch(text); match.hasNext();)
        found.insert(match.next().captured(1));
    return found;
}

QString accelerator_of(QString text) {
    text.remove("&&").remove(QRegularExpression("&[a-z]+;"));
    const qsizetype at = text.indexOf('&');
    return at < 0 ? QString() : text.mid(at + 1, 1).toLower();
}

TEST(Translations, AreCompleteInEveryLanguage) {
    for (const char* language : {"de", "en"}) {
        const std::vector<Translation> all = translations_in(translation_file(language));
        EXPECT_FALSE(all.empty());
        for (const Translation& one : all) {
            SCOPED_TRACE(language + std::string(": ") + one.source.toStdString());
            EXPECT_TRUE(one.finished);
            EXPECT_EQ(one.forms.size(), one.numbered ? 2 : 1);
            for (const QString& form : one.forms) {
                EXPECT_FALSE(form.trimmed().isEmpty());
                EXPECT_EQ(places_in(form), places_in(one.source)) << form.toStdString();
                EXPECT_EQ(accelerator_of(form).isEmpty(), accelerator_of(one.source).isEmpty())
                    << form.toStdString();
                EXPECT_EQ(form.count('<'), one.source.count('<')) << form.toStdString();
            }
        }
    }
}

// What lupdate finds in the sources is what the files hold.
TEST(Translations, KnowEveryWordOfTheSources) {
    const QString folder_of_lupdate = "/usr/lib/qt6/bin";
    if (!QFile::exists(folder_of_lupdate + "/lupdate")) GTEST_SKIP() << "there is no lupdate";
    const QTemporaryDir folder;
    for (const char* language : {"de", "en"}) {
        const QString file = translation_file(language);
        ASSERT_TRUE(QFile::copy(file, folder.filePath(QFileInfo(file).fileName())));
    }
    QProcess update;
    update.start(HEPATICA_SOURCE_DIR "/scripts/update_translations", {folder.path()});
    ASSERT_TRUE(update.waitForFinished(patience_ms));
    ASSERT_EQ(update.exitCode(), 0) << update.readAllStandardError().toStdString();
    for (const char* language : {"de", "en"}) {
        const QString file = translation_file(language);
        const auto sources = [](const std::vector<Translation>& all) {
            std::set<QString> found;
            for (const Translation& one : all) found.insert(one.source);
            return found;
        };
        const auto kept = sources(translations_in(file));
        const auto found = sources(translations_in(folder.filePath(QFileInfo(file).fileName())));
        for (const QString& one : found)
            EXPECT_TRUE(kept.contains(one))
                << language << " lacks, run scripts/update_translations: " << one.toStdString();
        for (const QString& one : kept)
            EXPECT_TRUE(found.contains(one))
                << language << " holds what nobody says any more: " << one.toStdString();
    }
}

TEST_F(GermanWindow, SaysItsMenusInGerman) {
    QStringList titles;
    for (const QAction* menu : window_.menuBar()->actions()) titles << menu->text();
    EXPECT_EQ(titles,
              QStringList({"&Datei", "&Üben", "&Ansicht", "&Messen", "&Lektion", "&Hilfe"}));
    EXPECT_EQ(window_.actions()[ActionId::save_case].text(), "Fall &speichern");
    EXPECT_EQ(window_.actions()[ActionId::save_case].shortcut(), QKeySequence("Ctrl+S"));
}

TEST_F(GermanWindow, SaysInGermanWhatEachEditIsFor) {
    auto& tool = *window_.findChild<QComboBox*>("EditTool");
    ASSERT_GT(tool.count(), 1);
    const auto labels = tool.parentWidget()->findChildren<QLabel*>("quiet");
    ASSERT_FALSE(labels.empty());
    for (int i = tool.count() - 1; i >= 0; --i) {
        tool.setCurrentIndex(i);
        const QString tip = tool.itemData(i, Qt::ToolTipRole).toString();
        EXPECT_FALSE(tip.startsWith("Click")) << tip.toStdString();
        EXPECT_EQ(labels.front()->text(), tip);
    }
}

void expect_accelerators_of_their_own(const QMenu& menu) {
    std::map<QString, QString> seen;
    for (const QAction* action : menu.actions()) {
        if (action->menu() != nullptr) expect_accelerators_of_their_own(*action->menu());
        const QString key = accelerator_of(action->text());
        if (key.isEmpty()) continue;
        const auto [first, is_new] = seen.emplace(key, action->text());
        EXPECT_TRUE(is_new) << menu.title().toStdString() << ": " << key.toStdString() << " opens "
                            << first->second.toStdString() << " and "
                            << action->text().toStdString();
    }
}

TEST_F(GermanWindow, HasNoAcceleratorTwiceInOneMenu) {
    for (const QAction* menu : window_.menuBar()->actions())
        expect_accelerators_of_their_own(*menu->menu());
}

TEST_F(GermanWindow, WritesNumbersWithAComma) {
    auto* field = window_.findChild<DecimalSpinBox*>("toolRadius");
    ASSERT_NE(field, nullptr);
    field->setValue(2.5);
    EXPECT_EQ(field->cleanText(), "2,5");
    for (const char* typed : {"3,5", "3.5"}) {
        field->setValue(1.0);
        field->findChild<QLineEdit*>()->setText(QString(typed) + " mm");
        field->interpretText();
        EXPECT_EQ(field->value(), 3.5) << typed;
    }
    // Files and shaders are written and read by the standard library.
    EXPECT_STREQ(std::localeconv()->decimal_point, ".");
}

TEST_F(GermanWindow, BeginsANewLessonInGerman) {
    Lesson lesson = new_lesson_in_words();
    EXPECT_EQ(lesson.name, "Neue Lektion");
    EXPECT_TRUE(gaps_in(lesson).empty());
    EXPECT_EQ(lesson.marks.front().name, "Marke 1");
    EXPECT_EQ(free_mark_name_in_words(lesson), "Marke 2");
    EXPECT_EQ(new_step_in_words().text, "Was der Übende tun soll.");
}

// A step has a goal, a drug has a target; both stand in the panel of one lesson.
TEST_F(GermanWindow, NamesAGoalAndATargetByTwoWords) {
    EXPECT_EQ(Words::tr("Goal"), "Ziel");
    for (const char* of_target : {"dose in the target", "the target", "Target of the drug",
                                  "share of the target that the drug has reached"})
        EXPECT_TRUE(Words::tr(of_target).contains("Zielgebiet")) << of_target;
}

// A play of the vessels is practice, "Übung", as the menu says, and no game.
TEST_F(GermanWindow, CallsAPlayPracticeAndNoGame) {
    static const QRegularExpression game("\\b(Spiel|spiel|gespielt|Gespielt)",
                                         QRegularExpression::UseUnicodePropertiesOption);
    const std::vector<Translation> all = translations_in(translation_file("de"));
    EXPECT_GT(all.size(), 1000u);
    for (const Translation& one : all)
        for (const QString& form : one.forms)
            EXPECT_FALSE(form.contains(game)) << form.toStdString();
    EXPECT_EQ(Words::tr("Record the play"), "Die Übung aufzeichnen");
}

TEST_F(GermanWindow, SaysAllSixViewsInGerman) {
    QStringList views;
    for (int id = static_cast<int>(ActionId::view_anterior);
         id <= static_cast<int>(ActionId::view_inferior); ++id)
        views << window_.actions()[static_cast<ActionId>(id)].text().remove('&');
    EXPECT_EQ(views, QStringList({"Vorn", "Hinten", "Links", "Rechts", "Oben", "Unten"}));
}

// "New course" is also what the window calls one, and has a translation.
TEST_F(GermanWindow, CallsACourseAsItsAuthorDidAndTheProgramsOwnInGerman) {
    EXPECT_NE(translated("New course"), "New course");
    ResultsDialog dialog([](const std::string&) {}, nullptr);
    const auto* title = dialog.findChild<QLabel*>("resultsTitle");
    dialog.show_results("New course", {});
    EXPECT_TRUE(title->text().startsWith("<b>New course</b>")) << title->text().toStdString();
    dialog.show_results("First steps", {});
    EXPECT_TRUE(title->text().startsWith("<b>Erste Schritte</b>")) << title->text().toStdString();
}

TEST_F(GermanWindow, CopiesALessonOfTheProgramInGerman) {
    LessonEditor& editor = window_.lesson_editor();
    for (const BuiltInLesson& entry : built_in_lessons()) {
        SCOPED_TRACE(entry.id);
        editor.findChild<QAction*>(QString("beginWith_") + entry.id)->trigger();
        const Lesson copy = editor.document().lesson(), english = find_lesson(entry.id);
        const auto expect_german = [](const std::string& said, const std::string& in_english) {
            EXPECT_EQ(said, translated(in_english).toStdString());
            EXPECT_TRUE(in_english.empty() || said != in_english) << said;
        };
        expect_german(copy.name, english.name);
        expect_german(copy.about, english.about);
        for (std::size_t m = 0; m < english.marks.size(); ++m)
            expect_german(copy.marks[m].name, english.marks[m].name);
        for (std::size_t s = 0; s < english.steps.size(); ++s) {
            expect_german(copy.steps[s].text, english.steps[s].text);
            expect_german(copy.steps[s].hint, english.steps[s].hint);
        }
        EXPECT_NO_THROW(lesson_of(text_of(copy), "the copy"));
    }
}

// Its words are longer: only when it is shown is it known how wide it is.
TEST_F(GermanWindow, HasItsLessonEditorWhollyOnTheScreen) {
    const QRect screen = window_.screen()->availableGeometry();
    window_.move(screen.right() + 1 - window_.width(), screen.bottom() + 1 - window_.height());
    LessonEditor& editor = window_.lesson_editor();
    editor.show_editor();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&editor, patience_ms));
    EXPECT_TRUE(screen.contains(editor.frameGeometry()))
        << editor.frameGeometry().right() << " of " << screen.right();
}

TEST_F(GermanWindow, SaysInItsToolBarWhatItsMenuSays) {
    EXPECT_EQ(window_.actions()[ActionId::reset].iconText(), "Zurücksetzen");
    EXPECT_EQ(window_.actions()[ActionId::toggle_clip].text(), "Ansicht aufschnei&den");
}

TEST_F(GermanWindow, ShowsAllOfItsToolBarOnASmallScreen) {
    EXPECT_LE(window_.findChild<QToolBar*>("Tools")->sizeHint().width(), 1280);
}

TEST_F(LanguageChoice, WritesNumbersWithAPointInEnglish) {
    auto* field = window_.findChild<DecimalSpinBox*>("toolRadius");
    ASSERT_NE(field, nullptr);
    field->setValue(2.5);
    EXPECT_EQ(field->cleanText(), "2.5");
}

TEST_F(LanguageChoice, IsKeptAndHoldsFromTheNextWindowOn) {
    EXPECT_EQ(settings_.language(), "");
    EXPECT_TRUE(window_.findChild<QAction*>("language_")->isChecked());
    window_.findChild<QAction*>("language_de")->trigger();
    EXPECT_EQ(settings_.language(), "de");
    EXPECT_TRUE(window_.messages().text().contains("next start"));

    use_language(settings_.language());
    {
        MainWindow next(settings_, {});
        EXPECT_EQ(next.menuBar()->actions().front()->text(), "&Datei");
        EXPECT_TRUE(next.findChild<QAction*>("language_de")->isChecked());
    }
    use_language("en");
}

TEST_F(LanguageChoice, AsksForNoRestartForTheLanguageThatIsSpoken) {
    const auto said = [this] { return window_.messages().text().contains("next start"); };
    window_.findChild<QAction*>("language_en")->trigger();
    EXPECT_EQ(settings_.language(), "en") << "whatever the system speaks later";
    EXPECT_FALSE(said());
    window_.findChild<QAction*>("language_de")->trigger();
    EXPECT_TRUE(said());
    window_.findChild<QAction*>("language_en")->trigger();
    EXPECT_FALSE(said());
}

TEST_F(LanguageChoice, CanMakeTheWindowAnewWithItsPatient) {
    open_built_in();
    std::optional<OpenRequest> shown;
    int begun = 0;
    window_.on_begin_anew([&](const std::optional<OpenRequest>& patient) {
        shown = patient;
        ++begun;
    });
    window_.findChild<QAction*>("language_de")->trigger();
    EXPECT_EQ(begun, 0);
    for (auto* button : window_.messages().findChildren<QPushButton*>())
        if (button->text() == "Restart now") button->click();
    EXPECT_EQ(begun, 1);
    EXPECT_FALSE(window_.isVisible());
}

// ctest runs it under several locales, see CMakeLists.txt.
TEST(LanguageOfTheSystem, HoldsWhereNoneIsChosen) {
    const QString expected = qEnvironmentVariable("HEPATICA_EXPECTED_LANGUAGE", language_of({}));
    EXPECT_EQ(language_of(""), expected);
    EXPECT_EQ(language_of("klingon"), expected);
    EXPECT_EQ(language_of("de"), "de");
    EXPECT_EQ(language_of("en"), "en");
}

// A process of its own, for the system's locale is read once. Its language is German, its numbers
// are those of the C locale.
TEST(NumbersOfAMixedSystem, AreWrittenOneWay) {
    constexpr const char* mixed = "HEPATICA_TEST_IN_MIXED_LOCALE";
    if (!qEnvironmentVariableIsSet(mixed)) {
        QProcess itself;
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert(mixed, "1");
        environment.insert("LANGUAGE", "de");
        environment.insert("LC_ALL", "C.UTF-8");
        itself.setProcessEnvironment(environment);
        itself.start(QCoreApplication::applicationFilePath(),
                     {"--gtest_filter=NumbersOfAMixedSystem.*"});
        ASSERT_TRUE(itself.waitForFinished(patience_ms));
        EXPECT_EQ(itself.exitCode(), 0) << itself.readAllStandardOutput().toStdString();
        return;
    }
    use_language("");
    EXPECT_EQ(spoken_language(), "de");
    const DecimalSpinBox field(0.0, 9.0, 2.5, 1, "");
    EXPECT_EQ(QString("%L1").arg(2.5, 0, 'f', 1), "2,5");
    EXPECT_EQ(field.text(), "2,5");
    EXPECT_EQ(QLocale().toString(2.5, 'f', 1), "2,5");
}

}  // namespace
}  // namespace hepatica::testing
