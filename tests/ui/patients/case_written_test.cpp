// SPDX-License-Identifier: GPL-3.0-or-later
// What is done to a case that was written is done to none that was only opened.
#include "tests/ui/patients/keeper_test.h"

namespace hepatica {
namespace {

class CaseWritten : public testing::KeeperTest {};

TEST_F(CaseWritten, is_told_of_a_case_that_is_saved_and_of_none_that_is_opened) {
    EXPECT_EQ(ward.written, std::vector<std::string>{"a.hep"});
    ward.open("a.hep");
    ASSERT_TRUE(ward.finish());
    EXPECT_EQ(ward.workspace().folder(), testing::FakeWard::path_of("a.hep"));
    EXPECT_EQ(ward.written.size(), 1u);
    ward.disk_full = true;
    save_as("b.hep");
    ASSERT_TRUE(ward.finish());
    EXPECT_EQ(ward.written.size(), 1u);
}

}  // namespace
}  // namespace hepatica
