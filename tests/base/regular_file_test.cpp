// SPDX-License-Identifier: GPL-3.0-or-later
// What is no file is refused before it is opened.
#include "core/base/regular_file.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <string>

#include "core/base/error.h"
#include "core/base/file_blocks.h"
#include "core/base/temporary_folder.h"
#include "core/base/text_file.h"

namespace hepatica {
namespace {

namespace fs = std::filesystem;

std::string problem_of(const fs::path& file, const std::function<void()>& read) {
    try {
        read();
    } catch (const InputError& error) {
        EXPECT_EQ(error.place(), file.string());
        EXPECT_EQ(error.remedy(), "Choose a file");
        return error.problem();
    }
    return "none";
}

TEST(RegularFile, IsWhatMayBeRead) {
    const TemporaryFolder folder;
    const fs::path file = folder.path() / "a.txt";
    std::ofstream(file) << "a";
    fs::create_symlink(file, folder.path() / "link");
    for (const fs::path& good : {file, folder.path() / "link", folder.path() / "missing",
                                 fs::path("/dev/stdin"), fs::path("/dev/fd/0")})
        EXPECT_EQ(problem_of(good, [&] { require_regular_file(good); }), "none") << good;
    const fs::path no_file = folder.path();
    EXPECT_EQ(problem_of(no_file, [&] { require_regular_file(no_file); }), "is a folder");
}

// Nobody writes into the pipe: who opens it waits for ever.
TEST(RegularFile, IsNoDeviceAndNoPipeForAnyReader) {
    const TemporaryFolder folder;
    const fs::path pipe = folder.path() / "case.json";
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    for (const fs::path& file : {fs::path("/dev/null"), pipe}) {
        const std::string expected = "is a pipe, a socket or a device, not a file";
        ASSERT_EQ(problem_of(file, [&] { read_text_file(file, "Choose a file"); }), expected);
        ASSERT_EQ(problem_of(file, [&] { for_each_block(file, [](auto) {}); }), expected);
    }
}

}  // namespace
}  // namespace hepatica
