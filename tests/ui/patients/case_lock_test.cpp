// SPDX-License-Identifier: GPL-3.0-or-later
// Who has a case open is told to others who open it, as long as he does.
#include "ui/case_lock.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <QSysInfo>
#include <QTemporaryDir>
#include <fstream>

#include "tests/ui/patients/fake_ward.h"
#include "ui/paths.h"

namespace hepatica {
namespace {

namespace fs = std::filesystem;

class LockOfCase : public ::testing::Test {
  protected:
    LockOfCase() {
        testing::need_event_loop();
        fs::create_directories(place_);
    }

    QTemporaryDir temporary_;
    fs::path folder_ = to_path(temporary_.path());
    fs::path place_ = folder_ / "a.hep";
    fs::path file_ = folder_ / ".a.hep.lock";
    CaseLock first_, second_;
};

TEST_F(LockOfCase, TellsTheSecondWhoOpensItOnceAndBothOpenIt) {
    EXPECT_EQ(first_.follow(place_), std::nullopt);
    EXPECT_TRUE(fs::exists(file_));
    EXPECT_EQ(second_.follow(place_), QSysInfo::machineHostName());
    EXPECT_EQ(second_.follow(place_), std::nullopt) << "he knows";
    second_.follow(folder_ / "b.hep");
    EXPECT_EQ(second_.follow(place_), QSysInfo::machineHostName()) << "he opens it anew";
}

TEST_F(LockOfCase, EndsWithTheCaseAndPassesToWhoHasItStill) {
    first_.follow(place_);
    second_.follow(place_);
    first_.follow({});
    second_.follow(place_);  // as with each change
    EXPECT_EQ(first_.follow(place_), QSysInfo::machineHostName());
    second_.follow(folder_ / "b.hep");
    EXPECT_EQ(CaseLock().follow(place_), std::nullopt);
    EXPECT_FALSE(fs::exists(file_)) << "nothing is left beside the case";
}

TEST_F(LockOfCase, IsTheSameThroughALink) {
    fs::create_symlink(place_, folder_ / "link.hep");
    first_.follow(place_);
    EXPECT_EQ(second_.follow(folder_ / "link.hep"), QSysInfo::machineHostName());
}

// The lock file of a process that has ended stays behind.
TEST_F(LockOfCase, OfAProgramThatDiedDoesNotCount) {
    const pid_t child = fork();
    if (child == 0) {
        CaseLock lock;
        lock.follow(place_);
        _exit(0);  // without a destructor
    }
    ASSERT_GT(child, 0);
    ASSERT_EQ(waitpid(child, nullptr, 0), child);
    ASSERT_TRUE(fs::exists(file_)) << "else nothing is tried";
    EXPECT_EQ(first_.follow(place_), std::nullopt);
    EXPECT_EQ(second_.follow(place_), QSysInfo::machineHostName()) << "the first has it now";
}

TEST_F(LockOfCase, NeedsNoFolderThatCanBeWritten) {
    EXPECT_EQ(first_.follow(folder_ / "missing" / "a.hep"), std::nullopt);
    if (geteuid() == 0) GTEST_SKIP() << "root may write everywhere";
    fs::permissions(folder_, fs::perms::owner_read | fs::perms::owner_exec);
    EXPECT_EQ(first_.follow(place_), std::nullopt);
    fs::permissions(folder_, fs::perms::owner_all);
    EXPECT_EQ(first_.follow(place_), std::nullopt);
    EXPECT_TRUE(fs::exists(file_)) << "it is tried again";
}

}  // namespace
}  // namespace hepatica
