// SPDX-License-Identifier: GPL-3.0-or-later
// Which patient a review is on: the one that is shown, a case that is known, or one that is chosen.
#include <QDir>
#include <QFile>
#include <QPushButton>
#include <fstream>

#include "tests/ui/review_window_test.h"
#include "ui/message_bar.h"

namespace hepatica {
namespace {

using testing::ReviewWindowTest;
using testing::wait_for;

// A later patient does not begin what was given up, be it the same one.
TEST_F(ReviewWindowTest, is_given_up_with_the_opening_of_its_patient) {
    endless_ = true;
    window_.open(to_text(file_));
    ASSERT_TRUE(wait_for([this] { return window_.busy(); }));
    window_.cancel_job();
    ASSERT_TRUE(wait_for([this] { return !window_.busy(); }));
    endless_ = false;
    open_built_in();
    paint();
    EXPECT_FALSE(dock().reviewing());
    EXPECT_FALSE(dock().busy());
}

TEST_F(ReviewWindowTest, of_another_patient_is_refused_with_the_remedy) {
    open_built_in();
    Recording other = played().recording;
    other.patient_hash ^= 1;
    write_recording(file_, other);
    window_.open(to_text(file_));
    EXPECT_TRUE(wait_for([this] { return window_.messages().text().contains("another patient"); }));
    EXPECT_TRUE(window_.messages().text().contains("Choose the case that was played on"));
    EXPECT_FALSE(dock().reviewing());
    EXPECT_EQ(opened_, 1);
}

// After a crash the vessels that were played on may be those of the unsaved corrections.
TEST_F(ReviewWindowTest, of_another_patient_names_the_unsaved_work_where_there_is_some) {
    Recording other = played().recording;
    other.patient_hash ^= 1;
    write_recording(file_, other);
    for (const bool unsaved : {false, true}) {
        std::string remedy;
        ReviewDock::Ways ways;
        ways.patient = [] { return test::small_patient(); };
        ways.beside = [](const auto&...) {};
        ways.lesson_runs = [] { return false; };
        ways.failed = [](const Failure& failure) { ADD_FAILURE() << failure.problem; };
        ways.say = [](const QString&) {};
        ways.work_is_unsaved = [unsaved] { return unsaved; };
        ways.choose_case = [&remedy](const Failure& failure, const auto&) {
            remedy = failure.remedy;
        };
        ReviewDock review(std::move(ways), nullptr);
        review.open(file_);
        ASSERT_TRUE(wait_for([&] { return !remedy.empty(); }));
        EXPECT_EQ(remedy.find("Open the unsaved work first (File > Open unsaved work)") == 0,
                  unsaved)
            << remedy;
    }
}

// The correction ends a review that begins before it is there; and whoever was played on may be the
// very one that is being made.
TEST_F(ReviewWindowTest, waits_for_no_correction_but_says_that_there_is_one) {
    for (const bool while_reading : {false, true}) {
        bool changes = !while_reading;
        Recording recorded = played().recording;
        recorded.patient_hash ^= while_reading ? 1 : 0;
        write_recording(file_, recorded);
        std::string problem;
        ReviewDock::Ways ways;
        ways.patient = [] { return test::small_patient(); };
        ways.use = [](std::unique_ptr<Simulation>) { ADD_FAILURE() << "it is shown"; };
        ways.beside = [](const auto&...) {};
        ways.lesson_runs = [] { return false; };
        ways.vessels_change = [&] { return changes; };
        ways.failed = [&](const Failure& failure) { problem = failure.problem; };
        ways.say = [](const QString&) {};
        ways.choose_case = [](const Failure& failure, const auto&) {
            ADD_FAILURE() << failure.problem;
        };
        ReviewDock review(std::move(ways), nullptr);
        review.open(file_);
        changes = true;
        ASSERT_TRUE(wait_for([&] { return !problem.empty(); }));
        EXPECT_TRUE(problem.starts_with("the vessels are being corrected")) << problem;
        EXPECT_TRUE(wait_for([&] { return !review.busy(); }));
    }
}

// A free play on a case that lies elsewhere now.
TEST_F(ReviewWindowTest, names_the_case_that_it_was_played_on_and_lets_one_choose_it) {
    opens_other_ = true;
    open_built_in();
    const QString lay = folder_.filePath("anna.hep");
    settings_.remember_patient(played().recording.patient_hash, lay);
    window_.open(to_text(file_));
    EXPECT_TRUE(wait_for([&] { return window_.messages().text().contains(lay); }))
        << window_.messages().text().toStdString();
    auto* choose = window_.messages().findChild<QPushButton*>("secondOffer");
    ASSERT_TRUE(choose->isVisible());
    QDir(folder_.path()).mkpath("moved/anna.hep");
    QFile header(folder_.filePath("moved/anna.hep/case.json"));
    ASSERT_TRUE(header.open(QIODevice::WriteOnly));
    header.close();
    opens_other_ = false;
    choose_file(folder_.filePath("moved/anna.hep"));
    QTest::mouseClick(choose, Qt::LeftButton);
    EXPECT_TRUE(wait_for([this] { return dock().complete(); }));
    EXPECT_EQ(opened_, 2);
}

// The vessels that were played on are those of the unsaved work: the case as it was saved last
// would have been refused.
TEST_F(ReviewWindowTest, of_an_interrupted_play_opens_the_unsaved_work_by_itself) {
    namespace fs = std::filesystem;
    const fs::path recordings = to_path(settings_.recordings_folder());
    fs::create_directories(recordings);
    fs::copy_file(file_, recordings / "play.hrec");
    std::ofstream(recordings / "play.hrec.unfinished").flush();
    const fs::path copy = to_path(settings_.recovery_folder()) / "left" / "1" / "Anna.hep";
    const fs::path saved = to_path(folder_.filePath("Anna.hep"));
    for (const fs::path& place : {copy, saved}) {
        fs::create_directories(place);
        std::ofstream(place / "case.json").flush();
    }
    settings_.remember_patient(played().recording.patient_hash, to_text(saved));
    std::vector<bool> unsaved;
    MainWindow next(settings_,
                    {[&unsaved](const OpenRequest& request, Job& job) {
                         unsaved.push_back(request.unsaved_copy);
                         return play(request.unsaved_copy ? test::small_patient() : other_patient(),
                                     job);
                     },
                     [](const fs::path&, const PatientCase&) {}},
                    answers());
    next.show();
    auto* look_back = next.messages().findChild<QPushButton*>("secondOffer");
    ASSERT_EQ(look_back->text(), "Look back on the play");
    look_back->click();
    EXPECT_TRUE(wait_for([&] { return next.review().complete(); }));
    EXPECT_EQ(unsaved, std::vector{true}) << "and nobody else";
    EXPECT_FALSE(next.messages().text().contains("not there any more"))
        << next.messages().text().toStdString();
}

// Who has to open the unsaved work first need not look for it in a menu.
TEST_F(ReviewWindowTest, of_another_patient_offers_the_unsaved_work_by_a_button) {
    opens_other_ = true;
    open_built_in();
    const auto copy = to_path(settings_.recovery_folder()) / "left" / "1" / "Anna.hep";
    std::filesystem::create_directories(copy);
    QFile header(to_text(copy / "case.json"));
    ASSERT_TRUE(header.open(QIODevice::WriteOnly));
    header.close();
    settings_.remember_patient(played().recording.patient_hash, folder_.filePath("anna.hep"));
    window_.open(to_text(file_));
    EXPECT_TRUE(wait_for([&] {
        return window_.messages().text().contains("Open the unsaved work first");
    })) << window_.messages().text().toStdString();
    auto* open = window_.messages().findChild<QPushButton*>("offer");
    ASSERT_TRUE(open->isVisible());
    EXPECT_EQ(open->text(), "Open the unsaved work");
    EXPECT_TRUE(window_.messages().findChild<QPushButton*>("secondOffer")->isVisible());
    const int before = opened_;
    QTest::mouseClick(open, Qt::LeftButton);
    EXPECT_TRUE(wait_for([&] { return opened_ > before && !window_.busy(); }));
}

// As long as it lies there, nobody is asked.
TEST_F(ReviewWindowTest, opens_the_case_that_it_was_played_on_where_that_is_known) {
    opens_other_ = true;
    open_built_in();
    QDir(folder_.path()).mkpath("anna.hep");
    QFile header(folder_.filePath("anna.hep/case.json"));
    ASSERT_TRUE(header.open(QIODevice::WriteOnly));
    header.close();
    settings_.remember_patient(played().recording.patient_hash, folder_.filePath("anna.hep"));
    opens_other_ = false;
    std::filesystem::create_directories(to_path(folder_.filePath("plays")));
    const auto elsewhere = to_path(folder_.filePath("plays/play.hrec"));
    std::filesystem::copy(file_, elsewhere);
    window_.open(to_text(elsewhere));
    EXPECT_TRUE(wait_for([this] { return dock().complete(); }));
    EXPECT_EQ(opened_, 2);
}

// Nobody needs a case to have him.
TEST_F(ReviewWindowTest, of_a_lesson_on_the_built_in_patient_needs_no_case_of_him) {
    opens_other_ = true;
    open_built_in();
    settings_.remember_patient(played().recording.patient_hash, folder_.filePath("gone.hep"));
    opens_other_ = false;
    dock().open(file_, "look_around");
    EXPECT_TRUE(wait_for([this] { return opened_ == 2; }));
    EXPECT_TRUE(wait_for([this] { return !window_.busy() && !dock().busy(); }));
}

TEST_F(ReviewWindowTest, ends_where_another_patient_is_opened) {
    open_built_in();
    look_back();
    window_.open(OpenRequest{true, {}});
    EXPECT_TRUE(wait_for([this] { return opened_ == 2 && !window_.busy(); }));
    paint();
    EXPECT_FALSE(dock().reviewing());
    EXPECT_TRUE(dock().isHidden());
}

// As the message asks; whoever opens another one first is waited for.
TEST_F(ReviewWindowTest, begins_where_its_case_is_opened_by_hand) {
    opens_other_ = true;
    open_built_in();
    settings_.remember_patient(played().recording.patient_hash, folder_.filePath("anna.hep"));
    window_.open(to_text(file_));
    ASSERT_TRUE(wait_for([this] { return window_.messages().text().contains("anna.hep"); }));
    window_.open(folder_.filePath("berta.hep"));
    ASSERT_TRUE(wait_for([this] { return opened_ == 2 && !window_.busy(); }));
    paint();
    EXPECT_FALSE(dock().reviewing() || dock().busy());
    opens_other_ = false;
    window_.open(folder_.filePath("anna.hep"));
    EXPECT_TRUE(wait_for([this] { return dock().complete(); }));
    EXPECT_EQ(opened_, 3);
    EXPECT_FALSE(window_.messages().text().contains("anna.hep")) << "nothing is left to be asked";
}

// The recording that was opened last is the one that waits.
TEST_F(ReviewWindowTest, is_not_waited_for_once_another_is_looked_at) {
    opens_other_ = true;
    open_built_in();
    settings_.remember_patient(played().recording.patient_hash, folder_.filePath("anna.hep"));
    window_.open(to_text(file_));
    ASSERT_TRUE(wait_for([this] { return window_.messages().text().contains("anna.hep"); }));
    window_.open(folder_.filePath("none.hrec"));
    ASSERT_TRUE(wait_for([this] { return window_.messages().text().contains("none.hrec"); }));
    opens_other_ = false;
    window_.open(folder_.filePath("anna.hep"));
    ASSERT_TRUE(wait_for([this] { return opened_ == 2 && !window_.busy(); }));
    paint();
    EXPECT_FALSE(dock().reviewing() || dock().busy());
}

}  // namespace
}  // namespace hepatica
