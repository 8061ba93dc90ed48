// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/atomic_write.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>
#include <fstream>
#include <iterator>
#include <string>

#include "core/base/error.h"

namespace hepatica {
namespace {

namespace fs = std::filesystem;

class AtomicWrite : public testing::Test {
  protected:
    void SetUp() override {
        folder_ = fs::temp_directory_path() /
                  ("hepatica-atomic-" +
                   std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
        fs::remove_all(folder_);
        fs::create_directories(folder_);
    }
    void TearDown() override { fs::remove_all(folder_); }

    std::string read(const fs::path& file) const {
        std::ifstream in(file, std::ios::binary);
        return {std::istreambuf_iterator<char>(in), {}};
    }
    long entries() const {
        return std::distance(fs::directory_iterator(folder_), fs::directory_iterator());
    }

    fs::path folder_;
};

TEST_F(AtomicWrite, ReplacesAFileWhole) {
    write_text_atomically(folder_ / "a.txt", "first");
    write_text_atomically(folder_ / "a.txt", "second");
    EXPECT_EQ(read(folder_ / "a.txt"), "second");
    EXPECT_EQ(entries(), 1);
}

TEST_F(AtomicWrite, KeepsTheOldFileAndLeavesNothingWhenWritingFails) {
    write_text_atomically(folder_ / "a.txt", "old");
    EXPECT_THROW(write_file_atomically(folder_ / "a.txt",
                                       [](const fs::path& temporary) {
                                           std::ofstream(temporary) << "half";
                                           throw Cancelled();
                                       }),
                 Cancelled);
    EXPECT_EQ(read(folder_ / "a.txt"), "old");
    EXPECT_EQ(entries(), 1);
}

TEST_F(AtomicWrite, ReplacesAFolderWhole) {
    const auto write = [&](const std::string& name) {
        write_folder_atomically(folder_ / "case.hep/", [&](const fs::path& temporary) {
            std::ofstream(temporary / name) << name;
        });
    };
    write("one");
    write("two");
    EXPECT_FALSE(fs::exists(folder_ / "case.hep" / "one"));
    EXPECT_EQ(read(folder_ / "case.hep" / "two"), "two");
    EXPECT_EQ(entries(), 1);
}

TEST_F(AtomicWrite, KeepsTheOldFolderWhenWritingFails) {
    write_folder_atomically(folder_ / "c", [](const fs::path& t) { std::ofstream(t / "x") << 1; });
    EXPECT_THROW(write_folder_atomically(folder_ / "c", [](const fs::path&) { throw Cancelled(); }),
                 Cancelled);
    EXPECT_EQ(read(folder_ / "c" / "x"), "1");
    EXPECT_EQ(entries(), 1);
}

TEST_F(AtomicWrite, NamesTheFileWhenTheDiskIsFull) {
    // A limit on the size of files makes writes fail half-way, as a full disk does.
    rlimit unlimited{};
    getrlimit(RLIMIT_FSIZE, &unlimited);
    const rlimit tiny{1000, unlimited.rlim_max};
    const auto handler = signal(SIGXFSZ, SIG_IGN);
    setrlimit(RLIMIT_FSIZE, &tiny);
    std::string message;
    try {
        write_text_atomically(folder_ / "a.txt", std::string(100'000, 'x'));
    } catch (const InputError& error) {
        message = error.what();
    }
    setrlimit(RLIMIT_FSIZE, &unlimited);
    signal(SIGXFSZ, handler);
    EXPECT_NE(message.find("a.txt"), std::string::npos) << message;
    EXPECT_EQ(entries(), 0);
}

TEST_F(AtomicWrite, RefusesAPlaceThatCannotBeWritten) {
    EXPECT_THROW(write_text_atomically("/proc/no/such/place.txt", "x"), InputError);
}

}  // namespace
}  // namespace hepatica
