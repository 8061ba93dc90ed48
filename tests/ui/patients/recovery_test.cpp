// SPDX-License-Identifier: GPL-3.0-or-later
// Copies of unsaved work: there as soon as something would be lost, gone as soon as nothing would,
// and offered by the next program where this one ends without a word.
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

class Unsaved : public testing::UnsavedTest {};

TEST_F(Unsaved, IsOfferedByTheNextProgramOnceThisOneIsGone) {
    auto crashed = program();
    workspace_.open(reconstructed());
    crashed->follow(workspace_);
    ASSERT_TRUE(rest(*crashed));
    EXPECT_TRUE(seen_by_another().empty()) << "it runs, and keeps it itself";
    crashed.reset();  // without end()
    const auto left = seen_by_another();
    ASSERT_EQ(left.size(), 1u);
    EXPECT_EQ(left[0].filename(), "anton.hep");
    EXPECT_EQ(hash_of(read_case(left[0])), hash_of(*test::small_patient()));
    EXPECT_TRUE(failures_.empty());
    // Nobody else may look at it.
    EXPECT_EQ(fs::status(left[0].parent_path().parent_path()).permissions(), fs::perms::owner_all);
}

// Although no body was made for it.
TEST_F(Unsaved, HoldsTumoursThatWerePainted) {
    auto crashed = program();
    OpenedPatient opened = reconstructed();
    auto patient = std::make_shared<PatientCase>(*opened.patient);
    patient->mask = Mask(Grid{{20, 20, 20}}, 1);
    opened.patient = patient;
    opened.worth_saving = false;
    workspace_.open(opened);
    workspace_.add(tumour_edit({{Vec3(10, 10, 10)}, 4.0, false}, 1));
    crashed->follow(workspace_);
    ASSERT_TRUE(rest(*crashed));
    crashed.reset();
    const auto left = seen_by_another();
    ASSERT_EQ(left.size(), 1u);
    const PatientCase kept = read_case(left[0]);
    EXPECT_EQ(kept.corrections.edits, workspace_.edits());
    EXPECT_EQ(tumours_in(kept.organs).size(), 1u);
}

// The case was renamed, or its disk taken out, while it was open.
TEST_F(Unsaved, IsKeptWholeAlthoughItsCaseIsNotThereAnyMore) {
    const fs::path place = fs::path(temporary_.path().toStdString()) / "anton.hep";
    PatientCase patient = *test::small_patient();
    patient.mask = Mask(Grid{{20, 20, 20}}, 1);
    write_case(place, patient);
    auto crashed = program();
    OpenedPatient opened = reconstructed();
    opened.patient = std::make_shared<const PatientCase>(read_case_without_voxels(place));
    opened.folder = place;
    workspace_.open(opened);
    fs::remove_all(place);
    crashed->follow(workspace_);
    ASSERT_TRUE(rest(*crashed));
    crashed.reset();
    EXPECT_TRUE(failures_.empty());
    const auto left = seen_by_another();
    ASSERT_EQ(left.size(), 1u);
    EXPECT_EQ(read_case(left[0]).mask.voxels, patient.mask.voxels);
}

TEST_F(Unsaved, IsGoneWhenItIsSavedOrTheProgramEnds) {
    auto recovery = program();
    workspace_.open(reconstructed());
    recovery->follow(workspace_);
    ASSERT_TRUE(rest(*recovery));
    workspace_.saved("/somewhere/a.hep", workspace_.edits(), {});
    recovery->follow(workspace_);
    recovery.reset();
    EXPECT_TRUE(seen_by_another().empty());

    auto second = program();
    workspace_.open(reconstructed("berta"));
    second->follow(workspace_);
    ASSERT_TRUE(rest(*second));
    second->end();
    second.reset();
    EXPECT_TRUE(seen_by_another().empty());
}

TEST_F(Unsaved, KeepsNothingWhereNothingWouldBeLost) {
    auto recovery = program();
    OpenedPatient opened = reconstructed();
    opened.worth_saving = false;
    workspace_.open(opened);
    recovery->follow(workspace_);
    QTest::qWait(0);
    EXPECT_TRUE(recovery->resting());
    EXPECT_TRUE(files().empty());
    // A correction without a body is kept once it has one.
    workspace_.add(testing::edit(1));
    recovery->follow(workspace_);
    EXPECT_TRUE(recovery->resting());
    auto corrected = std::make_shared<PatientCase>(*opened.patient);
    corrected->corrections.edits = workspace_.edits();
    workspace_.show_body(corrected);
    recovery->follow(workspace_);
    EXPECT_FALSE(recovery->resting());
}

TEST_F(Unsaved, KeepsTheNewestAndNeverNothing) {
    std::vector<std::string> written;
    auto recovery = program([&](const fs::path& place, const PatientCase& patient) {
        // The copy before is still there while the next one is written.
        if (!written.empty()) {
            bool before = false;
            for (const fs::path& file : files()) before |= file.filename() == "case.json";
            EXPECT_TRUE(before);
        }
        written.push_back(place.filename());
        write_case(place, patient);
    });
    workspace_.open(reconstructed("first"));
    recovery->follow(workspace_);
    ASSERT_TRUE(rest(*recovery));
    workspace_.open(reconstructed("second"));
    recovery->follow(workspace_);
    recovery->follow(workspace_);
    ASSERT_TRUE(rest(*recovery));
    recovery->follow(workspace_);  // nothing new
    EXPECT_TRUE(recovery->resting());
    EXPECT_EQ(written, (std::vector<std::string>{"first.hep", "second.hep"}));
    recovery.reset();
    const auto left = seen_by_another();
    ASSERT_EQ(left.size(), 1u);
    EXPECT_EQ(left[0].filename(), "second.hep");
}

TEST_F(Unsaved, IsOpenedWholeAndItsCopyGivesWayToTheProgramsOwn) {
    auto crashed = program();
    workspace_.open(reconstructed());
    crashed->follow(workspace_);
    ASSERT_TRUE(rest(*crashed));
    crashed.reset();
    const fs::path copy = seen_by_another().at(0);

    OpenRequest request;
    request.reconstruct.ct = copy;
    request.unsaved_copy = true;
    Job job;
    const OpenedPatient opened = open_patient(request, job);
    EXPECT_TRUE(opened.worth_saving);
    EXPECT_TRUE(opened.folder.empty());
    EXPECT_EQ(opened.kept_copy, copy);
    workspace_.open(opened);
    EXPECT_TRUE(workspace_.dirty());
    auto next = program();
    next->follow(workspace_);
    ASSERT_TRUE(rest(*next));
    EXPECT_FALSE(fs::exists(copy));
    EXPECT_TRUE(seen_by_another().empty());
    next.reset();  // it crashes, too
    EXPECT_EQ(seen_by_another().size(), 1u);

    // Saved at once, before the program has a copy of its own: the old one goes all the same.
    request.reconstruct.ct = seen_by_another().at(0);
    workspace_.open(open_patient(request, job));
    workspace_.saved("/somewhere/a.hep", workspace_.edits(), {});
    auto third = program();
    third->follow(workspace_);
    EXPECT_TRUE(seen_by_another().empty());
}

TEST_F(Unsaved, SaysWhereItCannotBeKept) {
    auto full = program([](const fs::path& place, const PatientCase&) {
        throw InputError("the disk is full", place.string(), "make room");
    });
    workspace_.open(reconstructed());
    full->follow(workspace_);
    ASSERT_TRUE(rest(*full));
    EXPECT_EQ(failures_, std::vector<std::string>{"the disk is full"});
    full.reset();
    EXPECT_TRUE(seen_by_another().empty());

    std::ofstream(folder_.string() + " file") << "no folder";
    folder_ += " file";
    auto nowhere = program();
    workspace_.open(reconstructed());
    nowhere->follow(workspace_);
    ASSERT_TRUE(QTest::qWaitFor([&] { return failures_.size() == 2; }, recovery_patience_ms));
}

TEST_F(Unsaved, HasANameThatIsOneFolder) {
    auto recovery = program();
    workspace_.open(reconstructed("../a/b.hepz"));
    recovery->follow(workspace_);
    ASSERT_TRUE(rest(*recovery));
    recovery.reset();
    EXPECT_EQ(seen_by_another().at(0).filename(), "case.._a_b.hep");
    EXPECT_TRUE(failures_.empty());
}

}  // namespace
}  // namespace hepatica
