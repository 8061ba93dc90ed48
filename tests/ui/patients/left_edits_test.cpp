// SPDX-License-Identifier: GPL-3.0-or-later
// Edits and strokes that a program writes as they are made, which the next one takes up where this
// one ends without a word.
#include "ui/recovery.h"

#include <gtest/gtest.h>

#include <QTemporaryDir>
#include <QTest>
#include <atomic>
#include <cmath>
#include <fstream>
#include <thread>

#include "core/base/error.h"
#include "core/opening/open_patient.h"
#include "core/patient/painted_tumours.h"
#include "tests/session/small_patient.h"
#include "tests/ui/patients/unsaved_test.h"

namespace hepatica {
namespace {

namespace fs = std::filesystem;

// What a program that is killed at this moment leaves: the same files, and nobody's lock on them.
class Journal : public testing::UnsavedTest {
  protected:
    Journal() {
        case_ = fs::path(temporary_.path().toStdString()) / "anton.hep";
        write_case(case_, *test::small_patient());
    }
    OpenedPatient from_disk() const {
        OpenRequest request;
        request.reconstruct.ct = case_;
        Job job;
        return open_patient(request, job);
    }
    // Empty: nothing was left, or it cannot be opened.
    std::vector<UnsavedWork> left_if_killed_now() {
        const fs::path copy =
            fs::path(temporary_.path().toStdString()) / ("killed " + std::to_string(++kills_));
        std::error_code ignored;  // files may come and go
        fs::copy(folder_, copy, fs::copy_options::recursive, ignored);
        for (const auto& program : fs::directory_iterator(copy, ignored))
            fs::remove(program.path() / "lock", ignored);
        std::vector<UnsavedWork> works;
        const Recovery next(copy, write_case, [](const Failure&) {});
        for (const fs::path& left : next.left_behind())
            works.push_back(Recovery::unsaved_work(left));
        return works;
    }
    bool leaves(const std::vector<int>& edits) {
        return QTest::qWaitFor(
            [&] {
                const auto works = left_if_killed_now();
                return works.size() == 1 && works[0].request.left_edits &&
                       testing::numbers_of(works[0].request.left_edits->edits) == edits;
            },
            recovery_patience_ms);
    }
    void add(int number, Recovery& recovery) {
        workspace_.add(testing::edit(number));
        recovery.follow(workspace_);
    }
    // Strokes at the vessels, each with how many corrections came before it: "2 after 1".
    bool leaves_strokes(const std::vector<std::string>& strokes) {
        return QTest::qWaitFor(
            [&] {
                const auto works = left_if_killed_now();
                return works.size() == 1 && works[0].request.left_edits &&
                       texts_of(works[0].request.left_edits->strokes) == strokes;
            },
            recovery_patience_ms);
    }
    static std::vector<std::string> texts_of(const std::vector<PendingStroke>& strokes) {
        std::vector<std::string> texts;
        for (const PendingStroke& one : strokes)
            texts.push_back(std::to_string(std::lround(one.stroke.path_mm.front().x())) +
                            " after " + std::to_string(one.after_edits));
        return texts;
    }
    void paint(int number, Recovery& recovery) {
        workspace_.add_stroke({{Vec3(number, 0, 0), Vec3(number, 1, 0)}, 2.0, false});
        recovery.follow(workspace_);
    }
    void show_body() {
        auto corrected = std::make_shared<PatientCase>(*workspace_.patient());
        corrected->corrections.extracted = test::small_patient()->tree;
        corrected->corrections.edits = workspace_.edits();
        workspace_.show_body(corrected);
    }

    fs::path case_;
    int kills_ = 0;
};

TEST_F(Journal, HoldsAnEditWhoseBodyIsStillBeingMade) {
    auto program = this->program();
    workspace_.open(from_disk());
    program->follow(workspace_);
    add(1, *program);
    add(2, *program);
    ASSERT_TRUE(workspace_.awaits_body());
    ASSERT_TRUE(program->resting()) << "no copy of the case is written as long as it has no body";
    ASSERT_TRUE(leaves({1, 2}));
    const UnsavedWork work = left_if_killed_now().at(0);
    EXPECT_EQ(work.title, "anton.hep");
    EXPECT_EQ(work.request.reconstruct.ct, case_);
    EXPECT_FALSE(work.request.unsaved_copy);
    Job job;
    const OpenedPatient opened = open_patient(work.request, job);
    EXPECT_EQ(opened.folder, case_);
    EXPECT_EQ(opened.kept_copy, work.request.left_edits->file);

    // Taken up by the next program: kept by it, and no longer by the one before.
    Recovery next(work.request.left_edits->file.parent_path().parent_path(), write_case,
                  [](const Failure&) {});
    EXPECT_EQ(next.left_behind().size(), 1u);
    Workspace taken_up;
    taken_up.open(opened);
    taken_up.take_up(*work.request.left_edits);
    taken_up.saved(case_, taken_up.edits(), {});
    next.follow(taken_up);
    EXPECT_TRUE(next.left_behind().empty());
}

TEST_F(Journal, FollowsUndoAndRedoAndGoesWithTheLastEdit) {
    auto program = this->program();
    workspace_.open(from_disk());
    add(1, *program);
    add(2, *program);
    workspace_.undo();
    program->follow(workspace_);
    EXPECT_TRUE(leaves({1}));
    workspace_.redo();
    program->follow(workspace_);
    EXPECT_TRUE(leaves({1, 2}));
    workspace_.saved(case_, workspace_.edits(), {});
    program->follow(workspace_);
    EXPECT_TRUE(left_if_killed_now().empty());
    add(3, *program);
    EXPECT_TRUE(leaves({1, 2, 3}));
    program->end();
    EXPECT_TRUE(left_if_killed_now().empty());
}

// The body is made already: nothing needs to be made again.
TEST_F(Journal, GivesWayToACopyThatHoldsAsMuch) {
    auto program = this->program();
    workspace_.open(from_disk());
    add(1, *program);
    show_body();
    program->follow(workspace_);
    ASSERT_TRUE(rest(*program));
    const UnsavedWork copy = left_if_killed_now().at(0);
    EXPECT_TRUE(copy.request.unsaved_copy);
    EXPECT_FALSE(copy.request.left_edits);
    add(2, *program);  // made on the copy, that is not whole without it
    ASSERT_TRUE(leaves({1, 2}));
    const UnsavedWork more = left_if_killed_now().at(0);
    EXPECT_TRUE(more.request.unsaved_copy);
    Job job;
    EXPECT_EQ(testing::numbers_of(open_patient(more.request, job).patient->corrections.edits),
              std::vector<int>{1});
}

// Else the work would be saved as a second case, and the lessons be those of the first.
TEST_F(Journal, TellsWhoseUnsavedWorkACopyHolds) {
    auto program = this->program();
    workspace_.open(from_disk());
    workspace_.set_digest("as it was opened");
    add(1, *program);
    show_body();
    program->follow(workspace_);
    ASSERT_TRUE(rest(*program));
    fs::path copy;
    EXPECT_TRUE(QTest::qWaitFor(
        [&] {
            const auto works = left_if_killed_now();
            if (works.empty()) return false;
            copy = works[0].request.reconstruct.ct;
            return Recovery::case_of(copy) == case_;
        },
        recovery_patience_ms));
    EXPECT_EQ(Recovery::digest_of(copy), "as it was opened");

    OpenRequest request;
    request.reconstruct.ct = copy;
    request.unsaved_copy = true;
    Job job;
    Workspace again;
    again.open(open_patient(request, job));
    EXPECT_TRUE(again.home().empty());
    again.set_recovered(case_);
    EXPECT_EQ(again.home(), case_);
    EXPECT_TRUE(again.folder().empty()) << "it is not in that case yet";
    again.saved("/somewhere/b.hep", again.edits(), {});
    EXPECT_EQ(again.home(), "/somewhere/b.hep");
    fs::remove_all(case_);
    EXPECT_TRUE(Recovery::case_of(copy).empty()) << "the case is gone";
}

TEST_F(Journal, WaitsForTheCopyOfWhatWasNeverSaved) {
    std::atomic<bool> held = true;
    auto program = this->program([&](const fs::path& place, const PatientCase& patient) {
        while (held) std::this_thread::yield();
        write_case(place, patient);
    });
    workspace_.open(reconstructed());
    program->follow(workspace_);
    ASSERT_TRUE(QTest::qWaitFor([&] { return !files().empty(); }, recovery_patience_ms));
    add(1, *program);
    EXPECT_TRUE(left_if_killed_now().empty()) << "there is nothing it could be made on";
    held = false;
    ASSERT_TRUE(leaves({1}));
    EXPECT_TRUE(left_if_killed_now().at(0).request.unsaved_copy);
}

TEST_F(Journal, IsNotOpenedOnAnotherPatient) {
    auto program = this->program();
    workspace_.open(from_disk());
    add(1, *program);
    ASSERT_TRUE(leaves({1}));
    const UnsavedWork work = left_if_killed_now().at(0);
    PatientCase other = *test::small_patient();
    other.tree.segments[0].radii_mm[0] *= 1.5;
    write_case(case_, other);
    Job job;
    EXPECT_THROW(open_patient(work.request, job), InputError);
}

// No case holds them, so that the case itself needs no copy.
TEST_F(Journal, HoldsStrokesThatWaitForARemaking) {
    auto program = this->program();
    workspace_.open(from_disk());
    paint(1, *program);
    paint(2, *program);
    ASSERT_TRUE(leaves_strokes({"1 after 0", "2 after 0"}));
    EXPECT_TRUE(program->resting());
    const UnsavedWork work = left_if_killed_now().at(0);
    EXPECT_EQ(work.title, "anton.hep");
    EXPECT_EQ(work.request.reconstruct.ct, case_);
    EXPECT_EQ(work.request.left_edits->strokes, workspace_.strokes());

    workspace_.undo_stroke();
    program->follow(workspace_);
    EXPECT_TRUE(leaves_strokes({"1 after 0"}));
    add(1, *program);
    paint(3, *program);
    EXPECT_TRUE(leaves_strokes({"1 after 0", "3 after 1"}));
    EXPECT_TRUE(leaves({1}));
    show_body();
    workspace_.saved(case_, workspace_.edits(), {});
    program->follow(workspace_);
    EXPECT_TRUE(leaves_strokes({"1 after 0", "3 after 1"})) << "the saved case has none of them";
    workspace_.undo_stroke();
    workspace_.undo_stroke();
    program->follow(workspace_);
    EXPECT_TRUE(left_if_killed_now().empty());
}

// No copy follows whose failure would be told.
TEST_F(Journal, SaysOnceThatStrokesOnASavedCaseCannotBeKept) {
    std::ofstream(folder_) << "no folder";
    std::vector<Failure> failures;
    Recovery program(folder_, write_case, [&](const Failure& one) { failures.push_back(one); });
    workspace_.open(from_disk());
    paint(1, program);
    ASSERT_FALSE(workspace_.dirty());
    ASSERT_EQ(failures.size(), 1u);
    EXPECT_EQ(failures[0].problem, "corrections cannot be noted at once");
    EXPECT_TRUE(failures[0].remedy.find("rebuild the vessels") != std::string::npos)
        << "no case would hold them";
    paint(2, program);
    EXPECT_EQ(failures.size(), 1u);
}

// The copy of the same version is whole but for the strokes.
TEST_F(Journal, SaysMoreThanACopyWhereStrokesWait) {
    auto program = this->program();
    workspace_.open(reconstructed());
    paint(1, *program);
    ASSERT_TRUE(leaves_strokes({"1 after 0"}));
    ASSERT_TRUE(rest(*program));
    EXPECT_TRUE(leaves_strokes({"1 after 0"}));
    const UnsavedWork work = left_if_killed_now().at(0);
    EXPECT_TRUE(work.request.unsaved_copy);
    workspace_.undo_stroke();
    program->follow(workspace_);
    EXPECT_TRUE(QTest::qWaitFor(
        [&] {
            const auto works = left_if_killed_now();
            return works.size() == 1 && !works[0].request.left_edits;
        },
        recovery_patience_ms))
        << "the copy holds as much";
}

TEST_F(Journal, HoldsWhatWasMeasuredThoughNoCopyIsEverWritten) {
    auto program = this->program(
        [](const fs::path&, const PatientCase&) { throw InputError("the disk is full", "", ""); });
    workspace_.open(from_disk());
    ASSERT_TRUE(workspace_.measure({{MeasurementKind::distance, {Vec3(1, 2, 3), Vec3(1, 2, 8)}}}));
    program->follow(workspace_);
    ASSERT_TRUE(leaves({}));
    EXPECT_EQ(left_if_killed_now().at(0).request.left_edits->measured, workspace_.measured());
}

// What the program before has left is let go only when this one's own journal is on disk.
TEST_F(Journal, OfStrokesIsTakenUpByTheNextProgram) {
    auto crashed = program();
    workspace_.open(from_disk());
    paint(1, *crashed);
    ASSERT_TRUE(leaves_strokes({"1 after 0"}));
    crashed.reset();
    auto next = program();
    ASSERT_EQ(next->left_behind().size(), 1u);
    const UnsavedWork work = Recovery::unsaved_work(next->left_behind().front());
    Job job;
    Workspace taken_up;
    taken_up.open(open_patient(work.request, job));
    taken_up.take_up(*work.request.left_edits);
    next->follow(taken_up);
    EXPECT_TRUE(next->left_behind().empty());
    EXPECT_TRUE(leaves_strokes({"1 after 0"})) << "by the program that has taken it up";
    EXPECT_TRUE(taken_up.unsaved());
    EXPECT_TRUE(taken_up.undo_is_of_stroke());
}

}  // namespace
}  // namespace hepatica
