// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/save_case_dialog.h"

#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QDialogButtonBox>
#include <QLineEdit>
#include <QPushButton>
#include <QTemporaryDir>
#include <filesystem>
#include <fstream>
#include <optional>

#include "ui/paths.h"

namespace hepatica {
namespace {

namespace fs = std::filesystem;

class SavingCase : public ::testing::Test {
  protected:
    SavingCase() { fs::create_directory(path("plain")); }
    fs::path path(const char* name) { return to_path(folder_.filePath(name)); }
    // What is chosen where this is typed; none where the dialog stays open.
    std::optional<fs::path> typed(const QString& name, bool may_replace) {
        asked_.clear();
        refused_.clear();
        SaveCaseDialog dialog(
            folder_.path(), "patient.hep",
            [&](const QString& old) {
                asked_ = old;
                return may_replace;
            },
            [this](const QString& why) { refused_ = why; });
        dialog.show();
        dialog.findChild<QLineEdit*>("fileNameEdit")->setText(name);
        dialog.accept();
        if (dialog.result() != QDialog::Accepted) return std::nullopt;
        return dialog.chosen();
    }

    QTemporaryDir folder_;
    QString asked_, refused_;
};

TEST_F(SavingCase, adds_the_ending_where_it_is_missing) {
    EXPECT_EQ(typed("a", false), path("a.hep"));
    EXPECT_EQ(typed("b.hep", false), path("b.hep"));
    EXPECT_EQ(typed("c.tar", false), path("c.tar.hep"));
    EXPECT_EQ(typed("d.hepz", false), path("d.hepz")) << "one file";
    EXPECT_EQ(asked_, "");
}

// Saving says then what is wrong with it.
TEST_F(SavingCase, takes_a_name_that_the_system_refuses_to_look_at) {
    EXPECT_NO_THROW(typed(QString("x").repeated(300), false));
    EXPECT_EQ(asked_, "");
    EXPECT_EQ(refused_, "");
}

TEST_F(SavingCase, replaces_an_old_case_after_asking_and_never_without) {
    fs::create_directory(path("old.hep"));
    std::ofstream(path("old.hep") / "case.json") << "{}";
    for (const char* name : {"old", "old.hep"}) {
        EXPECT_EQ(typed(name, true), path("old.hep")) << name;
        EXPECT_EQ(asked_, "old.hep");
        EXPECT_EQ(typed(name, false), std::nullopt);
    }
    EXPECT_EQ(typed("plain", true), std::nullopt) << "a folder that is no case is entered";
}

TEST_F(SavingCase, never_replaces_what_is_no_case_and_says_so) {
    fs::create_directory(path("photos.hep"));
    EXPECT_EQ(typed("photos.hep", true), std::nullopt);
    EXPECT_EQ(refused_, "") << "the folder is entered";
    std::ofstream(path("letter.hep")) << "Dear ...";
    std::ofstream(path("letter.hepz")) << "Dear ...";
    for (const auto& [name, taken] :
         {std::pair{"photos", "photos.hep"}, std::pair{"letter.hep", "letter.hep"},
          std::pair{"letter", "letter.hep"}, std::pair{"letter.hepz", "letter.hepz"}}) {
        EXPECT_EQ(typed(name, true), std::nullopt);
        EXPECT_TRUE(refused_.contains(QString("There is %1 already").arg(taken)))
            << name << ": " << refused_.toStdString();
        EXPECT_EQ(asked_, "");
    }
}

// A name with this ending is that of a file, so that the folder is not entered without a word.
TEST_F(SavingCase, says_that_a_file_cannot_take_the_place_of_a_folder) {
    fs::create_directory(path("photos.hepz"));
    EXPECT_EQ(typed("photos.hepz", true), std::nullopt);
    EXPECT_TRUE(refused_.startsWith("photos.hepz is a folder")) << refused_.toStdString();
}

// A case is a folder, which dialogs of files offer to open.
TEST_F(SavingCase, offers_to_save_over_an_old_case_and_not_to_open_it) {
    fs::create_directory(path("old.hep"));
    std::ofstream(path("old.hep") / "case.json") << "{}";
    SaveCaseDialog dialog(
        folder_.path(), "new.hep", [](const QString&) { return false; }, [](const QString&) {});
    dialog.show();
    const auto* save = dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Save);
    ASSERT_NE(save, nullptr);
    for (const char* name : {"new.hep", "old.hep", "old"}) {
        dialog.findChild<QLineEdit*>("fileNameEdit")->setText(name);
        QCoreApplication::processEvents();
        EXPECT_EQ(save->text().toStdString(), "&Save") << name;
    }
}

}  // namespace
}  // namespace hepatica
