// SPDX-License-Identifier: GPL-3.0-or-later
// A case in a folder that others use, too: the window says that another program has it open, asks
// before it replaces what was saved there meanwhile, and saves it although it was moved away.
#include <QAbstractButton>
#include <QApplication>
#include <QMessageBox>
#include <QPushButton>
#include <QStatusBar>
#include <QTimer>

#include "core/patient/patient_case.h"
#include "tests/patient/parted_patient.h"
#include "tests/ui/window_test.h"
#include "ui/case_lock.h"
#include "ui/edit_journal.h"
#include "ui/message_bar.h"
#include "ui/paths.h"
#include "ui/questions.h"

namespace hepatica::testing {
namespace {

namespace fs = std::filesystem;

// Along the straight vessel of parted_tree(), as a share of its length.
Vec3 on_straight_vessel(double share) {
    return Vec3(29, 49, 3) + share * Vec3(16, 11, 2);
}

class SharedCase : public WindowTest {
  protected:
    SharedCase() : WindowTest({load_for_processor, write_case}) {
        patient_.mask = Mask(Grid{{5, 4, 3}});
        patient_.mask.voxels[7] = 2;
        write_case(place_, patient_);
    }
    void open_case() { open(place_); }
    void open(const fs::path& place) {
        window_.open(to_text(place));
        wait();
    }
    void measure_distance() {
        QTest::keyClick(&window_, Qt::Key_M);
        for (const double share : {0.3, 0.7})
            QTest::mouseClick(&window_.view(), Qt::LeftButton, {},
                              on_widget(on_straight_vessel(share)));
        ASSERT_TRUE(window_.isWindowModified());
    }
    void save() {
        window_.actions()[ActionId::save_case].trigger();
        wait();
    }

    const fs::path place_ = to_path(folder_.filePath("a.hep"));
    PatientCase patient_ = test::patient_with_bridges();
};

TEST_F(SharedCase, SaysThatAnotherProgramHasItOpen) {
    open_case();
    EXPECT_FALSE(window_.messages().text().contains("is open in another program"));
    const fs::path second = to_path(folder_.filePath("b.hep"));
    write_case(second, patient_);
    open(second);
    CaseLock other;
    ASSERT_EQ(other.follow(place_), std::nullopt) << "the window has let it go";
    open_case();
    EXPECT_TRUE(window_.messages().text().contains("a.hep is open in another program, too"))
        << window_.messages().text().toStdString();
}

// A program that died has left work on it; who opens the case himself is told, too.
TEST_F(SharedCase, SaysThatWorkOnItWasLeftUnsaved) {
    const fs::path left = to_path(settings_.recovery_folder()) / "left";
    fs::create_directories(left);
    Journalled work;
    work.base = {"a.hep", place_, hash_of_extracted(read_case(place_))};
    work.change = 1;
    work.measured = {{.points_mm = {Vec3(1, 2, 3), Vec3(4, 5, 6)}}};
    {
        EditJournal journal(left / "edits.jsonl");
        journal.append(work);
    }
    open_case();
    EXPECT_TRUE(window_.messages().text().contains("without that work"))
        << window_.messages().text().toStdString();
    EXPECT_FALSE(window_.isWindowModified());
    auto* offer = window_.messages().findChild<QPushButton*>("offer");
    ASSERT_EQ(offer->text(), "Open it");
    offer->click();
    EXPECT_TRUE(wait_for([this] { return window_.isWindowModified(); }));
    EXPECT_FALSE(window_.messages().text().contains("without that work"));
    // The digest of the case as it was then is not known, so that it may have been changed.
    wait();
    save();
    EXPECT_EQ(changed_asked_, 1);
}

TEST_F(SharedCase, IsReplacedOnlyAfterAQuestion) {
    open_case();
    measure_distance();
    PatientCase of_another = patient_;
    of_another.measured = {{.points_mm = {Vec3(1, 2, 3), Vec3(4, 5, 6)}}};
    write_case(place_, of_another);
    save();
    EXPECT_EQ(changed_asked_, 1);
    EXPECT_EQ(read_case(place_).measured, of_another.measured);
    EXPECT_TRUE(window_.isWindowModified());
    changed_answer_ = ChangedAnswer::replace;
    save();
    EXPECT_NE(read_case(place_).measured, of_another.measured);
    EXPECT_FALSE(window_.isWindowModified());
}

TEST_F(SharedCase, IsSavedWholeAlthoughItWasMovedAway) {
    open_case();
    measure_distance();
    fs::rename(place_, to_path(folder_.filePath("moved.hep")));
    save();
    EXPECT_TRUE(window_.statusBar()->currentMessage().endsWith("it was saved anew"))
        << window_.messages().text().toStdString();
    const PatientCase saved = read_case(place_);
    EXPECT_EQ(saved.measured.size(), 1u);
    EXPECT_EQ(saved.mask.voxels, patient_.mask.voxels);
    EXPECT_EQ(changed_asked_, 0);
}

TEST(QuestionAboutAChangedCase, NamesItAndTakesThreeAnswers) {
    QWidget parent;
    const QTemporaryDir folder;
    const Settings settings(folder.filePath("settings.ini"));
    const PatientKeeper::Questions questions = questions_in_dialogs(parent, settings);
    for (const auto& [button, answer] : {std::pair{"Replace", ChangedAnswer::replace},
                                         std::pair{"Save as…", ChangedAnswer::save_as},
                                         std::pair{"Cancel", ChangedAnswer::cancel}}) {
        QString said;
        QTimer::singleShot(0, [&said, wanted = QString(button)] {
            auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
            ASSERT_NE(box, nullptr);
            said = box->text();
            for (QAbstractButton* one : box->buttons())
                if (one->text().remove('&') == wanted) return one->click();
            box->reject();
            ADD_FAILURE() << "no button is called " << wanted.toStdString();
        });
        EXPECT_EQ(questions.changed_on_disk("/disk/a.hep"), answer) << button;
        EXPECT_TRUE(said.contains("a.hep was changed on the disk")) << said.toStdString();
    }
}

}  // namespace
}  // namespace hepatica::testing
