// SPDX-License-Identifier: GPL-3.0-or-later
// Where a case is proposed to be saved.
#include "ui/patient_keeper.h"

#include <gtest/gtest.h>

#include <QDate>
#include <QDir>
#include <QTemporaryDir>
#include <QTest>

#include "core/patient/painted_tumours.h"
#include "tests/session/small_patient.h"
#include "tests/ui/patients/keeper_test.h"
#include "ui/edit_journal.h"
#include "ui/paths.h"

namespace hepatica {
namespace {

using testing::edit;
using testing::FakeWard;
using testing::numbers_of;
using Numbers = std::vector<int>;

class ProposedPlace : public testing::KeeperTest {};

TEST_F(ProposedPlace, recovered_work_is_saved_in_the_case_that_it_is_of) {
    const QTemporaryDir temporary;
    const std::filesystem::path folder = temporary.path().toStdString();
    const std::filesystem::path place = folder / "anton.hep";
    write_case(place, *test::small_patient());
    const std::filesystem::path program = folder / "program";
    std::filesystem::create_directories(program);
    {
        EditJournal journal(program / "edits.jsonl");
        Journalled noted;
        noted.base = {"anton.hep", ".", 0, place};
        noted.change = 1;
        journal.append(noted);
    }
    OpenRequest request;
    request.reconstruct.ct = program / "1" / "anton.hep";
    request.unsaved_copy = true;
    ward.keeper().open(request);
    ASSERT_TRUE(ward.finish());
    ASSERT_EQ(ward.workspace().title(), "anton.hep");
    EXPECT_TRUE(ward.workspace().dirty());
    ward.keeper().save();
    ASSERT_TRUE(ward.finish());
    EXPECT_EQ(ward.places_asked, 0);
    EXPECT_EQ(ward.written.back(), "anton.hep");
    EXPECT_EQ(ward.workspace().folder(), place);
    EXPECT_FALSE(ward.workspace().dirty());
    ward.keeper().ask_and_save();
    EXPECT_EQ(ward.proposed, place);
}

TEST_F(ProposedPlace, a_case_is_proposed_where_it_lies_or_by_its_name_alone) {
    ward.keeper().ask_and_save();
    EXPECT_EQ(ward.proposed, FakeWard::path_of("a.hep"));
    for (const auto& [ct, proposed] : {std::pair{"ct.nii.gz", "ct.hep"},
                                       {"ct9", "ct9.hep"},
                                       {"ct copy.hep", "ct copy.hep"},
                                       {"ct: 7?.nii", "ct 7.hep"}}) {
        ward.open(ct);
        ASSERT_TRUE(ward.finish());
        ward.answer = UnsavedAnswer::discard;
        ward.keeper().ask_and_save();
        EXPECT_EQ(ward.proposed, proposed) << "not beside the CT";
    }
}

// A folder of DICOM slices is often called as the patient.
TEST_F(ProposedPlace, a_case_is_not_called_as_the_folder_of_its_slices) {
    QTemporaryDir disk;
    ASSERT_TRUE(QDir(disk.path()).mkdir("ct Mustermann 1950"));
    OpenRequest request;
    request.reconstruct.ct = to_path(disk.filePath("ct Mustermann 1950"));
    ward.keeper().open(request);
    ASSERT_TRUE(ward.finish());
    ward.answer = UnsavedAnswer::discard;
    ward.keeper().ask_and_save();
    EXPECT_EQ(ward.proposed,
              "case of " + QDate::currentDate().toString(Qt::ISODate).toStdString() + ".hep");
}
TEST_F(ProposedPlace, paths_are_made_absolute) {
    OpenRequest request;
    request.reconstruct.ct = "some/../ct9";
    request.reconstruct.liver_mask = "liver.nii";
    ward.keeper().open(request);
    ASSERT_TRUE(ward.finish());
    EXPECT_EQ(ward.workspace().image(), std::filesystem::current_path() / "ct9");
    EXPECT_EQ(with_absolute_paths(request).reconstruct.liver_mask,
              std::filesystem::current_path() / "liver.nii");
}

}  // namespace
}  // namespace hepatica
