// SPDX-License-Identifier: GPL-3.0-or-later
// The patient as a DICOM segmentation: of whom, and what comes of it.
#include "tests/ui/patients/keeper_test.h"

namespace hepatica {
namespace {

class Archive : public testing::KeeperTest {};

// What fails or is cancelled says so and remembers nothing.
TEST_F(Archive, archives_the_patient_who_is_shown) {
    int written = 0;
    const auto archive = [&] {
        ward.keeper().archive("/ct", "/archive/a.dcm", [&written] { ++written; });
    };
    add(1);
    ASSERT_TRUE(ward.finish());
    archive();
    ASSERT_TRUE(ward.finish());
    EXPECT_EQ(ward.archived, std::vector<std::string>{"/ct to /archive/a.dcm with 1"});
    EXPECT_EQ(written, 1);
    EXPECT_EQ(ward.said.back(), "Saved /archive/a.dcm");
    ward.disk_full = true;
    archive();
    ASSERT_TRUE(ward.finish());
    EXPECT_EQ(ward.failures, std::vector<std::string>{"Writing a.dcm: the disk is full"});
    ward.disk_full = false;
    ward.hold_archiving = true;
    archive();
    ward.keeper().cancel();
    ASSERT_TRUE(ward.finish());
    EXPECT_EQ(ward.said.back(), "Not saved");
    EXPECT_EQ(written, 1);
    EXPECT_TRUE(ward.workspace().dirty()) << "the case itself is not saved by it";
}

TEST_F(Archive, archives_who_was_shown_when_it_was_asked) {
    ward.keeper().save();
    save_as("b.hep");
    ASSERT_TRUE(ward.finish());
    add(1);
    ASSERT_TRUE(ward.finish());
    ward.keeper().save();
    ASSERT_TRUE(ward.finish());
    ward.hold_openings = true;
    ward.open("a.hep");
    ward.keeper().archive("/ct of b", "/archive/b.dcm", [] {});
    ward.hold_openings = false;
    ASSERT_TRUE(ward.finish());
    EXPECT_EQ(ward.workspace().title(), "a.hep");
    EXPECT_EQ(ward.archived, std::vector<std::string>{"/ct of b to /archive/b.dcm with 1"});
}

TEST_F(Archive, what_is_being_archived_is_finished_before_the_end) {
    ward.hold_archiving = true;
    ward.keeper().archive("/ct", "/archive/a.dcm", [] {});
    ward.leave();
    EXPECT_FALSE(ward.left);
    ward.hold_archiving = false;
    ASSERT_TRUE(ward.finish());
    EXPECT_TRUE(ward.left);
    EXPECT_EQ(ward.archived.size(), 1u);
}

}  // namespace
}  // namespace hepatica
