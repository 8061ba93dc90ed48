// SPDX-License-Identifier: GPL-3.0-or-later
// What a killed writer left is gone after the next write; what may be somebody's only copy, or is
// being written, stays.
#include "core/base/leftovers.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <fstream>
#include <functional>
#include <iterator>
#include <string>
#include <vector>

#include "core/base/atomic_write.h"
#include "core/base/temporary_folder.h"

namespace hepatica {
namespace {

namespace fs = std::filesystem;

void put(const fs::path& file, const std::string& text) {
    std::ofstream(file) << text;
}

class Leftovers : public testing::Test {
  protected:
    fs::path in(const std::string& name) const { return folder_.path() / name; }
    // Hidden entries of the folder.
    std::vector<fs::path> left() const {
        std::vector<fs::path> found;
        for (const auto& entry : fs::directory_iterator(folder_.path()))
            if (entry.path().filename().string().starts_with(".hepatica-"))
                found.push_back(entry.path());
        return found;
    }
    // A process that does this and then ends without any of its destructors, as if killed.
    static void kill_in(const std::function<void()>& work) {
        const pid_t child = fork();
        if (child == 0) {
            work();
            _exit(1);
        }
        ASSERT_GT(child, 0);
        int status = 0;
        ASSERT_EQ(waitpid(child, &status, 0), child);
        ASSERT_EQ(WEXITSTATUS(status), 0) << "it went on to its end";
    }

    TemporaryFolder folder_;
};

TEST_F(Leftovers, OfAFileAndOfAFolderGoWithTheNextWriteOfTheSame) {
    kill_in([&] {
        write_file_atomically(in("k.hepz"), [](const fs::path& temporary) {
            put(temporary, "half");
            _exit(0);
        });
    });
    kill_in([&] {
        write_folder_atomically(in("k.hep"), [](const fs::path& temporary) {
            fs::create_directories(temporary / "deep");
            put(temporary / "deep" / "mask", "half");
            _exit(0);
        });
    });
    ASSERT_EQ(left().size(), 2u);
    write_text_atomically(in("k.hepz"), "whole");
    EXPECT_EQ(left().size(), 1u);
    write_folder_atomically(in("k.hep"), [](const fs::path& t) { put(t / "mask", "whole"); });
    EXPECT_TRUE(left().empty());
    EXPECT_TRUE(fs::exists(in("k.hep") / "mask"));
}

TEST_F(Leftovers, OfFilesAmongOthersGo) {
    kill_in([&] {
        write_files_atomically(folder_.path(), [](const fs::path& temporary) {
            put(temporary / "page.html", "half");
            _exit(0);
        });
    });
    ASSERT_EQ(left().size(), 1u);
    write_files_atomically(folder_.path(), [](const fs::path& t) { put(t / "page.html", "x"); });
    EXPECT_TRUE(left().empty());
}

// The writer was killed when the new folder stood in its place, before it had put them back.
TEST_F(Leftovers, KeepWhatOthersHadInTheFolder) {
    fs::create_directories(in("k.hep"));
    put(in("k.hep") / "mask", "old");
    put(in("k.hep") / "notes.txt", "of somebody");
    const auto renew = [&](const std::function<bool(const fs::path&)>& is_own) {
        renew_folder_atomically(
            in("k.hep"), [](const fs::path& t) { put(t / "mask", "new"); }, is_own);
    };
    kill_in([&] { renew([](const fs::path&) -> bool { _exit(0); }); });
    ASSERT_EQ(left().size(), 1u);
    const fs::path hidden = left().front();
    ASSERT_TRUE(fs::exists(hidden / "notes.txt"));
    renew([](const fs::path& below) { return below == "mask"; });
    EXPECT_EQ(left(), std::vector<fs::path>{hidden});
    EXPECT_TRUE(fs::exists(hidden / "notes.txt"));
    EXPECT_FALSE(fs::exists(hidden / "mask"));
}

TEST_F(Leftovers, OfALivingWriterStay) {
    write_file_atomically(in("a.txt"), [&](const fs::path& temporary) {
        put(temporary, "outer");
        write_text_atomically(in("a.txt"), "inner");
        EXPECT_TRUE(fs::exists(temporary)) << "of this process";
    });
    std::array<int, 2> begun{}, done{};
    ASSERT_EQ(pipe(begun.data()), 0);
    ASSERT_EQ(pipe(done.data()), 0);
    const pid_t child = fork();
    if (child == 0) {
        write_file_atomically(in("a.txt"), [&](const fs::path& temporary) {
            put(temporary, "of another");
            char word = 0;
            if (::write(begun[1], &word, 1) != 1 || ::read(done[0], &word, 1) != 1) _exit(1);
        });
        _exit(0);
    }
    char word = 0;
    ASSERT_EQ(::read(begun[0], &word, 1), 1);
    write_text_atomically(in("a.txt"), "meanwhile");
    EXPECT_EQ(left().size(), 1u) << "of another process";
    ASSERT_EQ(::write(done[1], &word, 1), 1);
    int status = 0;
    ASSERT_EQ(waitpid(child, &status, 0), child);
    EXPECT_EQ(WEXITSTATUS(status), 0);
    EXPECT_TRUE(left().empty());
}

TEST_F(Leftovers, OfAnotherFileGoOnlyWhereThatIsThere) {
    kill_in([&] {
        write_file_atomically(in("b.txt"), [](const fs::path& temporary) {
            put(temporary, "perhaps the only copy");
            _exit(0);
        });
    });
    write_text_atomically(in("a.txt"), "x");
    EXPECT_EQ(left().size(), 1u);
    put(in("b.txt"), "whole");
    write_text_atomically(in("a.txt"), "y");
    EXPECT_TRUE(left().empty());
}

// Nobody knows whether their writer lives.
TEST_F(Leftovers, OfOlderProgramsAndOtherComputersGoAfterAWeek) {
    for (const char* name : {".hepatica-40313022073-a.txt", ".hepatica-1.00000000-5-a.txt"})
        put(in(name), "half");
    write_text_atomically(in("a.txt"), "x");
    EXPECT_EQ(left().size(), 2u);
    for (const fs::path& file : left())
        fs::last_write_time(file, fs::last_write_time(file) - std::chrono::days(8));
    write_text_atomically(in("a.txt"), "y");
    EXPECT_TRUE(left().empty());
}

// Nor what was moved aside, which may be the only copy.
TEST_F(Leftovers, AreNotWhatAnotherHasNamedAlike) {
    for (const char* name : {".hepatica-notes", ".hepatica-my-a.txt", ".hepatica-1.x-y-a.txt",
                             ".hepatica-12-", ".hepatica-1.00000000-5-a.txt.old"}) {
        put(in(name), "mine");
        fs::last_write_time(in(name), fs::last_write_time(in(name)) - std::chrono::days(8));
    }
    put(in("notes"), "x");
    write_text_atomically(in("a.txt"), "y");
    EXPECT_EQ(left().size(), 5u);
}

}  // namespace
}  // namespace hepatica
