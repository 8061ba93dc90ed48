// SPDX-License-Identifier: GPL-3.0-or-later
// A case is known again by what it holds, in a folder and in one file.
#include "core/patient/case_digest.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "core/base/temporary_folder.h"
#include "core/patient/case_header.h"
#include "core/patient/corrections.h"
#include "tests/patient/some_patient.h"

namespace hepatica {
namespace {

namespace fs = std::filesystem;

class CaseDigest : public testing::TestWithParam<const char*> {
  protected:
    CaseDigest() { write_case(case_, patient_); }

    PatientCase patient_ = test::some_patient();
    TemporaryFolder folder_;
    fs::path case_ = folder_.path() / GetParam();
};

TEST_P(CaseDigest, StaysWhereTheSameIsWrittenAgainAndADialIsMeasured) {
    const std::string digest = digest_of_case(case_);
    EXPECT_EQ(digest.size(), 64u);
    write_case(case_, patient_);
    EXPECT_EQ(digest_of_case(case_), digest);
    write_dial(case_, R"({"measured": 1})");
    EXPECT_EQ(digest_of_case(case_), digest);
}

TEST_P(CaseDigest, ChangesWithCorrectionsWithVoxelsAndWithWhatWasMeasured) {
    const std::string digest = digest_of_case(case_);
    PatientCase corrected = patient_;
    note_rebuilding(patient_, 1, corrected);
    write_case(case_, corrected);
    const std::string of_corrected = digest_of_case(case_);
    EXPECT_NE(of_corrected, digest);
    PatientCase painted = patient_;
    painted.organs.at(3, 3, 3) = organ_label::first_tumour;
    write_case(case_, painted);
    EXPECT_NE(digest_of_case(case_), digest);
    PatientCase measured = patient_;
    measured.measured.push_back({.points_mm = {Vec3(1, 2, 3), Vec3(4, 5, 6)}});
    write_case(case_, measured);
    const std::string of_measured = digest_of_case(case_);
    EXPECT_NE(of_measured, digest);
    EXPECT_NE(of_measured, of_corrected);
}

TEST_P(CaseDigest, TellsACaseThatIsGoneFromOneThatCannotBeRead) {
    fs::remove_all(case_);
    EXPECT_EQ(digest_of_case(case_), "");
    fs::create_directories(folder_.path() / "no_case.hep");
    EXPECT_EQ(digest_of_case(folder_.path() / "no_case.hep"), "");
    std::ofstream(folder_.path() / "damaged.hepz") << "no archive";
    EXPECT_EQ(digest_of_case(folder_.path() / "damaged.hepz"), "unreadable");
}

INSTANTIATE_TEST_SUITE_P(InAFolderAndInOneFile, CaseDigest, testing::Values("p.hep", "p.hepz"));

}  // namespace
}  // namespace hepatica
