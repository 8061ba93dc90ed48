// SPDX-License-Identifier: GPL-3.0-or-later
// Which case is opened and under which name something is saved, as a person types and clicks it.
#include <QAbstractButton>
#include <QDir>
#include <QDockWidget>
#include <QFile>
#include <QFileDialog>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QStatusBar>
#include <QTableWidget>
#include <QTimer>

#include "core/base/atomic_write.h"
#include "core/lesson/attempts.h"
#include "tests/ui/fake_window_test.h"
#include "ui/attempts_dialog.h"
#include "ui/file_name.h"
#include "ui/lesson_dock.h"
#include "ui/message_bar.h"
#include "ui/open_case_dialog.h"
#include "ui/paths.h"
#include "ui/patient_wizard.h"
#include "ui/results_dialog.h"
#include "ui/save_file_dialog.h"

namespace hepatica {
namespace {

class OpenCase : public ::testing::Test {
  protected:
    OpenCase() {
        QDir(folder_.path()).mkpath("a.hep");
        QDir(folder_.path()).mkpath("plain");
        QDir(folder_.path()).mkpath("empty.hep");
        write("a.hep/case.json");
        write("b.hepz");
        write("ct.nii");
        dialog_.show();
    }
    void write(const char* name) {
        QFile file(folder_.filePath(name));
        ASSERT_TRUE(file.open(QIODevice::WriteOnly));
        file.write("{}");
    }
    void type(const QString& name) {
        // What is typed without the keyboard would stand behind what is chosen in the list.
        QApplication::setActiveWindow(&dialog_);
        auto* edit = dialog_.findChild<QLineEdit*>("fileNameEdit");
        edit->setFocus();
        ASSERT_TRUE(testing::wait_for([edit] { return edit->hasFocus(); }));
        edit->setText(name);
        dialog_.accept();
    }

    QTemporaryDir folder_;
    QString refused_;
    OpenCaseDialog dialog_{folder_.path(), [this](const QString& why) { refused_ = why; }};
};

TEST_F(OpenCase, TakesAFolder) {
    type("a.hep");
    EXPECT_EQ(dialog_.result(), QDialog::Accepted);
    EXPECT_EQ(dialog_.chosen(), to_path(folder_.filePath("a.hep")));
}

TEST_F(OpenCase, TakesOneFileByItsWholePath) {
    type(folder_.filePath("b.hepz"));
    EXPECT_EQ(dialog_.result(), QDialog::Accepted);
    EXPECT_EQ(dialog_.chosen(), to_path(folder_.filePath("b.hepz")));
}

TEST_F(OpenCase, TakesACaseThatIsEnteredByADoubleClick) {
    emit dialog_.directoryEntered(folder_.filePath("a.hep"));
    EXPECT_EQ(dialog_.result(), QDialog::Accepted);
    EXPECT_EQ(dialog_.chosen().filename(), "a.hep");
}

TEST_F(OpenCase, NamesTheFolderThatIsClickedOnce) {
    emit dialog_.currentChanged(folder_.filePath("a.hep"));
    dialog_.accept();
    EXPECT_EQ(dialog_.result(), QDialog::Accepted);
}

TEST_F(OpenCase, SaysWhyWhatIsNoCaseIsNotTaken) {
    type("ct.nii");
    EXPECT_TRUE(refused_.contains("ct.nii is no case")) << refused_.toStdString();
    EXPECT_TRUE(refused_.contains("Open CT file"));
    type("empty.hep");
    EXPECT_TRUE(refused_.contains("empty.hep is no case"));
    type("nothing.hep");
    EXPECT_EQ(refused_, "There is no nothing.hep.");
    EXPECT_TRUE(dialog_.isVisible());
    type("plain");
    EXPECT_EQ(dialog_.directory().absolutePath(), folder_.filePath("plain"))
        << "a folder is entered";
}

class NamedFiles : public testing::FakeWindowTest {
  protected:
    // What is typed into the next dialog of files.
    void type_when_asked(const QString& name) {
        name_ = name;
        QObject::connect(&answering_, &QTimer::timeout, &answering_, [this] {
            auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
            if (!dialog || name_.isEmpty()) return;
            dialog->findChild<QLineEdit*>("fileNameEdit")->setText(name_);
            name_.clear();
            QMetaObject::invokeMethod(dialog, "accept", Qt::QueuedConnection);
        });
        answering_.start(20);
    }
    // Where the next dialog of files begins that this opens, and the name that it proposes; it is
    // closed unanswered.
    QString begins_in(const std::function<void()>& open, QString* proposed = nullptr) {
        QString folder;
        QTimer looking;
        QObject::connect(&looking, &QTimer::timeout, &looking, [&] {
            auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
            if (!dialog) return;
            folder = dialog->directory().absolutePath();
            belongs_to_ = dialog->parentWidget();
            if (proposed) *proposed = dialog->findChild<QLineEdit*>("fileNameEdit")->text();
            dialog->reject();
        });
        looking.start(20);
        open();
        return folder;
    }
    void choose_from_menu(const QString& text) {
        for (QAction* action : window_.findChildren<QAction*>())
            if (action->text() == text) return action->trigger();
        ADD_FAILURE() << "there is no " << text.toStdString();
    }
    // The table of all results, with one in it.
    ResultsDialog& show_results() {
        Attempt attempt;
        attempt.recording = to_path(settings_.recordings_folder()) / "1.hrec";
        attempt.lesson_id = "gentle_pull";
        attempt.lesson = "Gentle pull";
        attempt.ended_at = "2026-01-01T00:00:00Z";
        attempt.name = "Anna";
        write_attempt(attempt);
        window_.lessons().show_results();
        auto* results = window_.findChild<QTableWidget*>("results");
        return dynamic_cast<ResultsDialog&>(*results->window());
    }
    QTimer answering_;
    QString name_;
    QWidget* belongs_to_ = nullptr;  // the window before which begins_in() saw a dialog
};

// Not in the home folder, nor where something of another kind lies.
TEST_F(NamedFiles, AreAskedForWhereOneOfTheirKindWasChosenLast) {
    for (const char* name : {"courses/c.json", "lessons/l.json", "scans/ct.nii"}) {
        QDir(folder_.path()).mkpath(QFileInfo(name).path());
        QFile file(folder_.filePath(name));
        ASSERT_TRUE(file.open(QIODevice::WriteOnly));
        file.write("{}");
    }
    const auto open_course = [this] { choose_from_menu("Open co&urse…"); };
    const auto open_lesson = [this] { choose_from_menu("&Open lesson…"); };
    const auto open_ct = [this] { window_.actions()[ActionId::open_ct_file].trigger(); };
    const auto open_scan = [this] { window_.actions()[ActionId::open_ct_folder].trigger(); };
    type_when_asked(folder_.filePath("courses/c.json"));
    open_course();
    type_when_asked(folder_.filePath("lessons/l.json"));
    open_lesson();
    type_when_asked(folder_.filePath("scans/ct.nii"));
    open_ct();
    answering_.stop();
    EXPECT_EQ(begins_in(open_course), folder_.filePath("courses"));
    EXPECT_EQ(begins_in(open_lesson), folder_.filePath("lessons"));
    EXPECT_EQ(begins_in(open_ct), folder_.filePath("scans"));
    EXPECT_EQ(begins_in(open_scan), folder_.filePath("scans"));
}

TEST_F(NamedFiles, GetTheSuffixOfTheirKind) {
    open_built_in();
    for (const auto& [typed, got] : {std::pair{"pic", "pic.png"}, std::pair{"b.2024", "b.2024.png"},
                                     std::pair{"c.PNG", "c.PNG"}}) {
        type_when_asked(folder_.filePath(typed));
        window_.actions()[ActionId::save_picture].trigger();
        EXPECT_TRUE(QFile::exists(folder_.filePath(got))) << got;
    }
    EXPECT_FALSE(QFile::exists(folder_.filePath("pic")));
    type_when_asked(folder_.filePath("branches"));
    EXPECT_EQ(ask_where_to_save_file(window_, "Save", folder_.filePath("x.csv"), "Tables (*.csv)"),
              folder_.filePath("branches.csv"));
}

TEST_F(NamedFiles, AreProposedWithTheNameOfTheirPatient) {
    open_built_in();
    QString proposed;
    const auto save_picture = [this] { window_.actions()[ActionId::save_picture].trigger(); };
    begins_in(save_picture, &proposed);
    EXPECT_EQ(proposed, "Fake patient picture.png");
    auto* table = window_.findChild<QTableWidget*>("branches");
    window_.findChild<QDockWidget*>("Branches")->show();
    ASSERT_TRUE(testing::wait_for([&] { return table->rowCount() > 0; }));
    begins_in([this] { window_.findChild<QPushButton*>("saveBranches")->click(); }, &proposed);
    EXPECT_EQ(proposed, "Fake patient branches.csv");
}

TEST_F(NamedFiles, OfTheBranchesAreConfirmedInTheStatusBar) {
    open_built_in();
    auto* table = window_.findChild<QTableWidget*>("branches");
    window_.findChild<QDockWidget*>("Branches")->show();
    ASSERT_TRUE(testing::wait_for([&] { return table->rowCount() > 0; }));
    const QString file = folder_.filePath("branches.csv");
    type_when_asked(file);
    window_.findChild<QPushButton*>("saveBranches")->click();
    EXPECT_TRUE(QFile::exists(file));
    EXPECT_EQ(window_.statusBar()->currentMessage(), "Saved " + file);
}

// When such a dialog is closed, its parent gets the keys: behind a table they would steer the play.
TEST_F(NamedFiles, AreAskedForBeforeTheWindowThatAsks) {
    ResultsDialog& results = show_results();
    auto* save = results.findChild<QPushButton*>("resultsSave");
    ASSERT_TRUE(save->isEnabled());
    begins_in([save] { save->click(); });
    EXPECT_EQ(belongs_to_, &results);
    AttemptsDialog& attempts = window_.lessons().attempts();
    attempts.show_lesson({"gentle_pull", "Gentle pull"}, to_path(settings_.recordings_folder()), "",
                         {});
    begins_in([&] { attempts.findChild<QPushButton*>("attemptsSave")->click(); });
    EXPECT_EQ(belongs_to_, &attempts);
    begins_in([this] { choose_from_menu("Edi&t course…"); });
    EXPECT_EQ(belongs_to_, &window_) << "the editor is not shown yet";
    const QString course = folder_.filePath("course.json");
    type_when_asked(course);
    choose_from_menu("Edi&t course…");
    answering_.stop();
    auto* copy = window_.findChild<QPushButton*>("courseCopy");
    ASSERT_TRUE(copy->isVisible());
    begins_in([copy] { copy->click(); });
    EXPECT_EQ(belongs_to_, copy->window());
}

TEST_F(NamedFiles, ThatCannotBeWrittenAreToldOfBeforeTheWindowThatAsked) {
    ResultsDialog& results = show_results();
    type_when_asked(folder_.filePath("none/results.csv"));
    results.findChild<QPushButton*>("resultsSave")->click();
    auto* told = results.findChild<QMessageBox*>();
    ASSERT_NE(told, nullptr);
    EXPECT_TRUE(told->text().contains("There is no such folder")) << told->text().toStdString();
    EXPECT_TRUE(window_.messages().text().isEmpty()) << "that is behind the table";
    told->close();
}

// A "/" would propose a folder, and the other characters a name that not every disk takes.
TEST_F(NamedFiles, AreCoursesCalledAsTheyAreAsFarAsAFileCanBe) {
    const QString course = folder_.filePath("course.json");
    write_text_atomically(to_path(course), R"({"format": "hepatica-course", "version": 1,
        "name": "Week 1/2: <veins>", "lessons": []})");
    QDir(folder_.path()).mkpath("Week 1");
    type_when_asked(course);
    choose_from_menu("Open co&urse…");
    answering_.stop();
    choose_from_menu("Edi&t course…");
    auto* copy = window_.findChild<QPushButton*>("courseCopy");
    ASSERT_NE(copy, nullptr);
    QString proposed;
    EXPECT_EQ(begins_in([copy] { copy->click(); }, &proposed), folder_.path());
    EXPECT_EQ(proposed, "Week 1 2 veins.json");
}

TEST(FileName, HoldsNothingThatAFileSystemRefuses) {
    EXPECT_EQ(as_file_name("Gentle pull, 2nd", "x"), "Gentle pull, 2nd");
    EXPECT_EQ(as_file_name("Über–Größe", "x"), "Über–Größe");
    EXPECT_EQ(as_file_name("../a\\b:c*d?e\"f<g>h|i\nj\x7fk", "x"), "a b c d e f g h i j k");
    EXPECT_EQ(as_file_name(".hidden. ", "x"), "hidden");
    for (const char* nothing : {"", " ", "/", "...", "?*"})
        EXPECT_EQ(as_file_name(nothing, "lesson"), "lesson") << nothing;
    const QString many = QString("a") + QString::fromUtf8("😀").repeated(200);
    const QString some = as_file_name(many, "x");
    EXPECT_LE(some.toUtf8().size(), 180);
    EXPECT_GE(some.toUtf8().size(), 170);
    EXPECT_TRUE(many.startsWith(some));
    EXPECT_EQ(QString::fromUtf8(some.toUtf8()), some) << "no half of a letter is left";
}

// A second patient of the day is not offered the place of the first.
TEST(FileName, IsOneThatIsFree) {
    const QTemporaryDir folder;
    EXPECT_EQ(free_name(folder.path(), "case of today.hep"), "case of today.hep");
    QDir(folder.path()).mkdir("case of today.hep");
    EXPECT_EQ(free_name(folder.path(), "case of today.hep"), "case of today (2).hep");
    QDir(folder.path()).mkdir("case of today (2).hep");
    EXPECT_EQ(free_name(folder.path(), "case of today.hep"), "case of today (3).hep");
    EXPECT_EQ(free_name(folder.filePath("nowhere"), "a.hep"), "a.hep");
}

TEST_F(NamedFiles, AreCasesCalledAsThePatientAndLieWhereTheyDo) {
    open_built_in();
    window_.actions()[ActionId::save_case_as].trigger();
    EXPECT_EQ(proposed_place_, "Fake patient.hep");
    window_.save_case(folder_.filePath("p.hep"));
    ASSERT_TRUE(testing::wait_for([this] { return !window_.busy(); }));
    window_.actions()[ActionId::save_case_as].trigger();
    EXPECT_EQ(proposed_place_, to_path(folder_.filePath("p.hep")));
}

class TypedReconstruction : public testing::FakeWindowTest {
  protected:
    void in_wizard(const std::function<void(PatientWizard&)>& act) {
        QTimer::singleShot(0, &window_, [&act] {
            act(dynamic_cast<PatientWizard&>(*QApplication::activeModalWidget()));
        });
        window_.actions()[ActionId::reconstruct].trigger();
    }
    // What the wizard offers, which is then cancelled.
    QStringList offered() {
        QStringList entries;
        in_wizard([&](PatientWizard& wizard) {
            entries = wizard.entries();
            wizard.reject();
        });
        return entries;
    }
};

// A mask of another CT is noticed only once both were read.
TEST_F(TypedReconstruction, that_fails_is_offered_as_it_was_typed) {
    const QStringList typed{"0",       "/no/ct",   "/no/liver", "/no/vessels", "/no/tumours",
                            "140 260", "20 20 20", "1",         "4 5 6"};
    in_wizard([&](PatientWizard& wizard) {
        wizard.set_entries(typed);
        wizard.findChild<QLineEdit*>("hepaticSeeds")->setText("1 2 3");
        wizard.accept();
    });
    ASSERT_TRUE(testing::wait_for([this] { return !window_.busy(); }));
    ASSERT_TRUE(window_.messages().text().contains("his is no image"));
    QStringList expected = typed;
    expected[7] = "1 2 3";
    EXPECT_EQ(offered(), expected);
    EXPECT_EQ(offered(), expected) << "a cancelled dialog changes nothing";
    open_built_in();
    EXPECT_EQ(offered().join(""), "0") << "the next patient begins with empty fields";
}

}  // namespace
}  // namespace hepatica
