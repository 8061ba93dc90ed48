// SPDX-License-Identifier: GPL-3.0-or-later
// The case of a recording is found beside it by its patient alone, whatever else lies there.
#include "core/opening/recorded_case.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "core/base/error.h"
#include "core/base/temporary_folder.h"
#include "core/patient/patient_case.h"
#include "tests/patient/parted_patient.h"

namespace hepatica {
namespace {

namespace fs = std::filesystem;

TEST(RecordedCase, IsTheFirstThatFitsAndWhatCannotBeReadIsPassedOver) {
    const TemporaryFolder folder;
    PatientCase other = test::patient_with_bridges(), wanted = other;
    wanted.tree.segments[0].radii_mm[0] += 0.5;
    write_case(folder.path() / "b other.hep", other);
    write_case(folder.path() / "c wanted.hepz", wanted);
    write_case(folder.path() / "d wanted.hep", wanted);
    fs::create_directory(folder.path() / "a damaged.hep");
    std::ofstream(folder.path() / "a damaged.hep" / "case.json") << "{";
    fs::create_directory_symlink("e itself", folder.path() / "e itself");
    const fs::path recording = folder.path() / "play.hrec";  // need not be there
    Job job;
    const CaseSearch search = case_beside(recording, hash_of(wanted), job);
    EXPECT_EQ(search.found, folder.path() / "c wanted.hepz");
    ASSERT_EQ(search.passed_over.size(), 1u);
    EXPECT_THAT(search.passed_over[0], testing::HasSubstr("a damaged.hep"));
    EXPECT_EQ(case_beside(recording, 12345, job).found, std::nullopt);
    job.cancel();
    EXPECT_THROW(case_beside(recording, 12345, job), Cancelled);
}

}  // namespace
}  // namespace hepatica
