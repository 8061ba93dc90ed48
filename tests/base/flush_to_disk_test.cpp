// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/flush_to_disk.h"

#include <gtest/gtest.h>

#include <fstream>

#include "core/base/error.h"
#include "core/base/temporary_folder.h"

namespace hepatica {
namespace {

TEST(FlushToDisk, TakesFilesAndFolders) {
    const TemporaryFolder folder;
    std::ofstream(folder.path() / "a.txt") << "a";
    EXPECT_NO_THROW(flush_to_disk(folder.path() / "a.txt", "a.txt"));
    EXPECT_NO_THROW(flush_to_disk(folder.path(), "the folder"));
}

// Nothing is behind it that could be waited for: fsync() fails with EINVAL.
TEST(FlushToDisk, TakesWhatHasNoDisk) {
    if (!std::filesystem::exists("/dev/null")) GTEST_SKIP() << "no /dev/null";
    EXPECT_NO_THROW(flush_to_disk("/dev/null", "nothing"));
}

TEST(FlushToDisk, NamesWhatTheUserKnowsAndTheReason) {
    const TemporaryFolder folder;
    try {
        flush_to_disk(folder.path() / "missing", "anton.hep");
        FAIL() << "a file that is missing was brought to the disk";
    } catch (const InputError& error) {
        EXPECT_EQ(error.place(), "anton.hep");
        EXPECT_EQ(error.problem(), "cannot be written (No such file or directory)");
        EXPECT_NE(error.remedy(), "");
    }
}

}  // namespace
}  // namespace hepatica
