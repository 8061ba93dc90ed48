// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/atomic_write.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/time.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <fstream>
#include <iterator>
#include <string>
#include <thread>
#include <utility>

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

// What others put into a folder of ours stays, at any depth; what is ours and not written anew
// goes.
TEST_F(AtomicWrite, RenewsItsOwnFilesAndKeepsThoseOfOthers) {
    const fs::path made = folder_ / "made";
    fs::create_directories(made / "ct" / "deep");
    for (const char* name : {"ours.txt", "ours_old.txt", "notes.txt", "ct/ours_1.txt",
                             "ct/deep/photo.txt", "both.txt"})
        std::ofstream(made / name) << "old";
    fs::create_symlink("nowhere", made / "link");
    renew_folder_atomically(
        made,
        [](const fs::path& temporary) {
            std::ofstream(temporary / "ours.txt") << "new";
            std::ofstream(temporary / "both.txt") << "new";
        },
        [](const fs::path& file) { return file.filename().string().starts_with("ours"); });
    EXPECT_EQ(read(made / "ours.txt"), "new");
    EXPECT_EQ(read(made / "both.txt"), "new") << "what is written wins";
    EXPECT_FALSE(fs::exists(made / "ours_old.txt"));
    EXPECT_FALSE(fs::exists(made / "ct" / "ours_1.txt"));
    EXPECT_EQ(read(made / "notes.txt"), "old");
    EXPECT_EQ(read(made / "ct" / "deep" / "photo.txt"), "old");
    EXPECT_TRUE(fs::is_symlink(made / "link"));
    EXPECT_EQ(entries(), 1) << "no temporary is left";
    EXPECT_THROW(
        renew_folder_atomically(
            made, [](const fs::path&) { throw Cancelled(); }, [](const fs::path&) { return true; }),
        Cancelled);
    EXPECT_EQ(read(made / "notes.txt"), "old");
    EXPECT_EQ(entries(), 1);
}

// The new folder has a file where the old one had a folder of somebody's.
TEST_F(AtomicWrite, SaysWhereAFileOfOthersIsThatCannotBePutBack) {
    const fs::path made = folder_ / "made";
    fs::create_directories(made / "ct");
    std::ofstream(made / "ct" / "photo.txt") << "mine";
    const auto write = [](const fs::path& temporary) { std::ofstream(temporary / "ct") << "new"; };
    try {
        renew_folder_atomically(made, write, [](const fs::path&) { return false; });
        ADD_FAILURE();
    } catch (const InputError& error) {
        EXPECT_EQ(read(error.place()), "mine") << "it is where the message says";
    }
    EXPECT_EQ(read(made / "ct"), "new");
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

TEST_F(AtomicWrite, PutsFilesBesideOthersOnlyWhenAllAreWritten) {
    write_text_atomically(folder_ / "mine.txt", "mine");
    const auto write = [&](const std::string& text, bool fails) {
        write_files_atomically(folder_, [&](const fs::path& temporary) {
            std::ofstream(temporary / "a.png") << text;
            if (fails) throw Cancelled();
            std::ofstream(temporary / "report.html") << text;
        });
    };
    EXPECT_THROW(write("half", true), Cancelled);
    EXPECT_EQ(entries(), 1);
    write("first", false);
    EXPECT_THROW(write("half", true), Cancelled);
    EXPECT_EQ(read(folder_ / "a.png"), "first");
    write("second", false);
    for (const char* name : {"a.png", "report.html"}) EXPECT_EQ(read(folder_ / name), "second");
    EXPECT_EQ(read(folder_ / "mine.txt"), "mine");
    EXPECT_EQ(entries(), 3);
}

TEST_F(AtomicWrite, LeavesNoNewFolderWhereWhatShouldBeInItIsNotWritten) {
    const auto write = [&](bool fails) {
        write_files_atomically(folder_ / "new" / "below" / "", [&](const fs::path& temporary) {
            std::ofstream(temporary / "a.png") << "text";
            if (fails) throw Cancelled();
        });
    };
    EXPECT_THROW(write(true), Cancelled);
    EXPECT_EQ(entries(), 0);
    fs::create_directories(folder_ / "new" / "below");
    EXPECT_THROW(write(true), Cancelled);
    EXPECT_TRUE(fs::is_directory(folder_ / "new" / "below")) << "was there before";
    fs::remove_all(folder_ / "new");
    write(false);
    EXPECT_EQ(read(folder_ / "new" / "below" / "a.png"), "text");
    fs::create_symlink(folder_ / "nowhere", folder_ / "link");
    EXPECT_THROW(write_files_atomically(folder_ / "link", [](const fs::path&) {}), InputError);
    EXPECT_TRUE(fs::is_symlink(folder_ / "link"));
}

TEST_F(AtomicWrite, WritesThroughALink) {
    write_text_atomically(folder_ / "real" / "a.txt", "old");
    fs::create_symlink(folder_ / "real" / "a.txt", folder_ / "link.txt");
    fs::create_directory_symlink(folder_ / "real", folder_ / "link");
    write_text_atomically(folder_ / "link.txt", "new");
    EXPECT_TRUE(fs::is_symlink(folder_ / "link.txt"));
    EXPECT_EQ(read(folder_ / "real" / "a.txt"), "new");
    write_folder_atomically(folder_ / "link", [](const fs::path& temporary) {
        std::ofstream(temporary / "b.txt") << "b";
    });
    EXPECT_TRUE(fs::is_symlink(folder_ / "link"));
    EXPECT_FALSE(fs::exists(folder_ / "real" / "a.txt"));
    EXPECT_EQ(read(folder_ / "real" / "b.txt"), "b");
    EXPECT_EQ(entries(), 3);
}

TEST_F(AtomicWrite, MakesTheTargetOfALinkThatLeadsToNothingYet) {
    fs::create_directories(folder_ / "real");
    fs::create_symlink("real/a.txt", folder_ / "second.txt");
    fs::create_symlink("second.txt", folder_ / "first.txt");
    write_text_atomically(folder_ / "first.txt", "new");
    for (const char* name : {"first.txt", "second.txt"})
        EXPECT_TRUE(fs::is_symlink(folder_ / name)) << name;
    EXPECT_EQ(read(folder_ / "real" / "a.txt"), "new");
    // As into a share that is not mounted, and in a circle.
    fs::create_symlink("no share/a.txt", folder_ / "away.txt");
    fs::create_symlink("circle.txt", folder_ / "circle.txt");
    for (const auto& [link, named] :
         {std::pair{"away.txt", "no share/a.txt"}, {"circle.txt", "circle.txt"}}) {
        try {
            write_text_atomically(folder_ / link, "new");
            ADD_FAILURE() << link;
        } catch (const InputError& error) {
            EXPECT_EQ(error.place(), (folder_ / named).string());
        }
        EXPECT_TRUE(fs::is_symlink(folder_ / link)) << link;
    }
    EXPECT_FALSE(fs::exists(folder_ / "no share"));
}

// A rename would put a file in its place.
TEST_F(AtomicWrite, WritesIntoAPipeAndWaitsForNoReader) {
    const fs::path pipe = folder_ / "pipe.csv";
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    EXPECT_THROW(write_text_atomically(pipe, "unread"), InputError);
    const int reader = open(pipe.c_str(), O_RDONLY | O_NONBLOCK);
    ASSERT_GE(reader, 0);
    fs::create_symlink(pipe, folder_ / "link.csv");
    write_text_atomically(pipe, "one ");
    write_file_atomically(folder_ / "link.csv", [](const fs::path& temporary) {
        EXPECT_EQ(temporary.extension(), ".csv");
        std::ofstream(temporary) << "two";
    });
    std::array<char, 64> read_back{};
    const ssize_t count = ::read(reader, read_back.data(), read_back.size());
    close(reader);
    EXPECT_EQ(std::string(read_back.data(), static_cast<std::size_t>(std::max<ssize_t>(count, 0))),
              "one two");
    EXPECT_TRUE(fs::is_fifo(pipe));
    EXPECT_EQ(entries(), 2) << "the pipe and its link";
}

// A file was put in the place of each.
TEST_F(AtomicWrite, WritesIntoAPipeAmongFiles) {
    const fs::path pipe = folder_ / "a.csv";
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    fs::create_symlink("/dev/null", folder_ / "null.csv");
    write_text_atomically(folder_ / "b.txt", "old");
    const auto write = [&] {
        write_files_atomically(folder_, [](const fs::path& temporary) {
            for (const char* name : {"a.csv", "b.txt", "null.csv"})
                std::ofstream(temporary / name) << "new";
        });
    };
    EXPECT_THROW(write(), InputError) << "nobody reads it";
    EXPECT_EQ(read(folder_ / "b.txt"), "old");
    const int reader = open(pipe.c_str(), O_RDONLY | O_NONBLOCK);
    ASSERT_GE(reader, 0);
    write();
    std::array<char, 64> read_back{};
    const ssize_t count = ::read(reader, read_back.data(), read_back.size());
    close(reader);
    EXPECT_EQ(std::string(read_back.data(), static_cast<std::size_t>(std::max<ssize_t>(count, 0))),
              "new");
    EXPECT_EQ(read(folder_ / "b.txt"), "new");
    EXPECT_TRUE(fs::is_fifo(pipe));
    EXPECT_TRUE(fs::is_symlink(folder_ / "null.csv"));
    EXPECT_TRUE(fs::is_character_file("/dev/null"));
    EXPECT_EQ(entries(), 3);
}

// More than a pipe holds, and nobody takes it out: without an end by signals this would not return.
TEST_F(AtomicWrite, WaitsForASlowReaderUntilASignalComes) {
    const fs::path pipe = folder_ / "pipe.csv";
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    const int reader = open(pipe.c_str(), O_RDONLY | O_NONBLOCK);
    ASSERT_GE(reader, 0);
    const auto before = std::signal(SIGALRM, [](int) {});
    const itimerval ticks{{0, 20'000}, {0, 20'000}};
    const itimerval none{};
    setitimer(ITIMER_REAL, &ticks, nullptr);
    EXPECT_THROW(write_text_atomically(pipe, std::string(1 << 20, 'x')), InputError);
    setitimer(ITIMER_REAL, &none, nullptr);
    std::signal(SIGALRM, before);
    close(reader);
}

// The temporary is hidden, and gone by the time that somebody reads its name.
TEST_F(AtomicWrite, NamesWhatATemporaryWouldHaveBecome) {
    const auto place_of = [](const auto& write) {
        try {
            write();
        } catch (const InputError& error) {
            return error.place();
        }
        return std::string("none");
    };
    const auto fail_at = [](const char* below) {
        return [below](const fs::path& temporary) {
            throw InputError("cannot be written", (temporary / below).string(), "");
        };
    };
    EXPECT_EQ(place_of([&] { write_folder_atomically(folder_ / "q.hep/", fail_at("tree.swc")); }),
              (folder_ / "q.hep" / "tree.swc").string());
    EXPECT_EQ(place_of([&] { write_files_atomically(folder_ / "out", fail_at("a.csv")); }),
              (folder_ / "out" / "a.csv").string());
    EXPECT_EQ(place_of([&] {
                  write_folder_atomically(folder_ / "outer", [&](const fs::path& temporary) {
                      write_file_atomically(temporary / "inner.txt", [](const fs::path& file) {
                          throw InputError("cannot be written", file.string() + ", line 1", "");
                      });
                  });
              }),
              (folder_ / "outer" / "inner.txt").string() + ", line 1");
    EXPECT_EQ(place_of([&] {
                  write_folder_atomically(folder_ / "q.hep", [](const fs::path&) {
                      throw InputError("cannot be read", "/elsewhere/ct", "");
                  });
              }),
              "/elsewhere/ct");
}

TEST_F(AtomicWrite, WritesFilesThroughLinks) {
    write_text_atomically(folder_ / "elsewhere" / "a.txt", "old");
    fs::create_directories(folder_ / "out");
    fs::create_symlink(folder_ / "elsewhere" / "a.txt", folder_ / "out" / "a.txt");
    write_files_atomically(folder_ / "out", [](const fs::path& temporary) {
        for (const char* name : {"a.txt", "b.txt"}) std::ofstream(temporary / name) << "new";
    });
    EXPECT_TRUE(fs::is_symlink(folder_ / "out" / "a.txt"));
    EXPECT_EQ(read(folder_ / "elsewhere" / "a.txt"), "new");
    EXPECT_EQ(read(folder_ / "out" / "b.txt"), "new");
    for (const char* folder : {"out", "elsewhere"})  // no temporary is left in either
        EXPECT_EQ(std::distance(fs::directory_iterator(folder_ / folder), {}),
                  std::string(folder) == "out" ? 2 : 1);
}

// A patient's folder that was closed to others stays closed when it is saved.
TEST_F(AtomicWrite, ShowsWhatItReplacesToNobodyElse) {
    const auto permissions = [&](const char* name) {
        return fs::status(folder_ / name).permissions();
    };
    constexpr fs::perms own_file = fs::perms::owner_read | fs::perms::owner_write;
    for (const char* name : {"a.txt", "b.txt", "made/c.txt"})
        write_text_atomically(folder_ / name, "old");
    const fs::perms usual = permissions("b.txt");
    for (const char* name : {"a.txt", "b.txt"}) fs::permissions(folder_ / name, own_file);
    fs::permissions(folder_ / "made", fs::perms::owner_all);
    write_text_atomically(folder_ / "a.txt", "new");
    EXPECT_EQ(permissions("a.txt"), own_file);
    fs::permissions(folder_ / "a.txt", usual);
    write_file_atomically(folder_ / "a.txt", [&](const fs::path& temporary) {
        std::ofstream(temporary) << "new";
        fs::permissions(temporary, own_file);
    });
    EXPECT_EQ(permissions("a.txt"), own_file) << "its writer closed it";
    write_files_atomically(folder_, [](const fs::path& temporary) {
        for (const char* name : {"b.txt", "d.txt"}) std::ofstream(temporary / name) << "new";
    });
    EXPECT_EQ(permissions("b.txt"), own_file);
    EXPECT_EQ(permissions("d.txt"), usual) << "nothing was there";
    renew_folder_atomically(
        folder_ / "made",
        [](const fs::path& temporary) {
            EXPECT_EQ(fs::status(temporary).permissions(), fs::perms::owner_all);
            std::ofstream(temporary / "c.txt") << "new";
        },
        [](const fs::path&) { return true; });
    EXPECT_EQ(permissions("made"), fs::perms::owner_all);
    EXPECT_EQ(read(folder_ / "made" / "c.txt"), "new");
}

// A folder stands where the third of four files should go.
TEST_F(AtomicWrite, PutsBackTheFilesBeforeOneThatCannotBeMoved) {
    write_text_atomically(folder_ / "a.txt", "old");
    write_text_atomically(folder_ / "c.txt" / "inside", "kept");
    std::string message;
    try {
        write_files_atomically(folder_, [](const fs::path& temporary) {
            for (const char* name : {"a.txt", "b.txt", "c.txt", "d.txt"})
                std::ofstream(temporary / name) << "new";
        });
    } catch (const InputError& error) {
        message = error.what();
    }
    EXPECT_NE(message.find("c.txt"), std::string::npos) << message;
    EXPECT_EQ(read(folder_ / "a.txt"), "old");
    EXPECT_FALSE(fs::exists(folder_ / "b.txt"));
    EXPECT_EQ(read(folder_ / "c.txt" / "inside"), "kept");
    EXPECT_EQ(entries(), 2);
}

TEST_F(AtomicWrite, TakesTheLongestNamesAndKeepsTheirEnd) {
    const std::string name = std::string(248, 'n') + ".nii.gz";
    write_file_atomically(folder_ / name, [](const fs::path& temporary) {
        EXPECT_TRUE(temporary.string().ends_with(".nii.gz"));
        std::ofstream(temporary) << "x";
    });
    EXPECT_EQ(read(folder_ / name), "x");
}

TEST_F(AtomicWrite, TwoWritersOfOnePlaceDoNotDisturbEachOther) {
    const auto writer = [&](char mark) {
        for (int i = 0; i < 50; ++i) {
            write_folder_atomically(folder_ / "case", [&](const fs::path& temporary) {
                for (const char* name : {"a", "b"})
                    std::ofstream(temporary / name) << std::string(1000, mark);
            });
        }
    };
    write_folder_atomically(folder_ / "case", [](const fs::path&) {});
    std::thread other(writer, 'x');
    writer('y');
    other.join();
    const std::string a = read(folder_ / "case" / "a");
    EXPECT_EQ(a.size(), 1000u);
    EXPECT_EQ(a, read(folder_ / "case" / "b"));
    EXPECT_EQ(entries(), 1);
}

TEST_F(AtomicWrite, KeepsTheOldFolderWhenWritingFails) {
    write_folder_atomically(folder_ / "c", [](const fs::path& t) { std::ofstream(t / "x") << 1; });
    EXPECT_THROW(write_folder_atomically(folder_ / "c", [](const fs::path&) { throw Cancelled(); }),
                 Cancelled);
    EXPECT_EQ(read(folder_ / "c" / "x"), "1");
    EXPECT_EQ(entries(), 1);
}

// A file was exchanged for the folder and left beside it under a hidden name.
TEST_F(AtomicWrite, AFolderTakesThePlaceOfNoFile) {
    const fs::path file = folder_ / "case.hepz";
    std::ofstream(file) << "a patient";
    bool written = false;
    const auto write = [&](const fs::path&) { written = true; };
    for (const fs::path& place : {file, file / ""}) {
        EXPECT_THROW(write_folder_atomically(place, write), InputError) << place;
        EXPECT_THROW(renew_folder_atomically(place, write, [](const fs::path&) { return false; }),
                     InputError)
            << place;
        EXPECT_EQ(read(file), "a patient");
        EXPECT_EQ(entries(), 1);
    }
    EXPECT_FALSE(written);
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
