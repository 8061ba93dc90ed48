// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/text_file.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <sstream>
#include <streambuf>

#include "core/base/error.h"
#include "core/base/json_depth.h"
#include "core/base/temporary_folder.h"

namespace hepatica {
namespace {

std::string problem_of(const std::filesystem::path& file) {
    try {
        read_text_file(file, "Give a letter");
    } catch (const InputError& error) {
        EXPECT_EQ(error.place(), file.string());
        EXPECT_EQ(error.remedy(), "Give a letter");
        return error.problem();
    }
    return "none";
}

TEST(TextFile, IsReadToTheLastByte) {
    const TemporaryFolder folder;
    const std::string text("a\r\nb\0c\n", 7);
    std::ofstream(folder.path() / "a.txt", std::ios::binary) << text;
    EXPECT_EQ(read_text_file(folder.path() / "a.txt", ""), text);
    std::ofstream(folder.path() / "empty.txt").close();
    EXPECT_EQ(read_text_file(folder.path() / "empty.txt", ""), "");
}

TEST(TextFile, SaysWhyItIsNone) {
    const TemporaryFolder folder;
    EXPECT_EQ(problem_of(folder.path() / "missing.txt"), "does not exist");
    EXPECT_EQ(problem_of(folder.path()), "is a folder");
}

// More than one block, and not a whole number of them.
TEST(TextFile, IsReadWholeWhateverItsLength) {
    const TemporaryFolder folder;
    for (const std::size_t bytes : {65535u, 65536u, 65537u, 200000u}) {
        std::string text;
        while (text.size() < bytes) text += static_cast<char>('a' + text.size() % 23);
        std::ofstream(folder.path() / "long.txt", std::ios::binary) << text;
        EXPECT_TRUE(read_text_file(folder.path() / "long.txt", "") == text) << bytes;
    }
}

// Delivers a few bytes; then a read fails, as that of a broken disk does.
class BreakingDisk : public std::streambuf {
  public:
    explicit BreakingDisk(int number) : number_(number) {}

  private:
    std::streamsize xsgetn(char* to, std::streamsize) override {
        std::fill_n(to, 3, 'x');
        errno = number_;
        throw std::ios_base::failure("a read failed");
    }
    int number_;
};

InputError error_of(std::istream& in, std::uint64_t least_bytes) {
    try {
        read_text_stream(in, least_bytes, "notes.txt");
    } catch (const InputError& error) {
        return error;
    }
    return {"none", "", ""};
}

TEST(TextFile, ThatFailsToBeReadIsNotTakenForAShorterOne) {
    BreakingDisk disk(EIO), silent(0);
    std::istream in(&disk), other(&silent);
    const InputError error = error_of(in, 0);
    EXPECT_EQ(error.problem(), "cannot be read (Input/output error)");
    EXPECT_EQ(error.place(), "notes.txt");
    EXPECT_EQ(error.remedy(), "Check the disk");
    EXPECT_EQ(error_of(other, 0).problem(), "cannot be read to its end");
}

// Reading a process's memory from address 0 on fails.
TEST(TextFile, ThatCannotBeReadIsRefusedByName) {
    const std::filesystem::path file = "/proc/self/mem";
    if (!std::filesystem::exists(file)) GTEST_SKIP() << "no " << file;
    try {
        read_text_file(file, "");
        FAIL() << "it was read";
    } catch (const InputError& error) {
        EXPECT_EQ(error.place(), file.string());
        EXPECT_EQ(error.problem(), "cannot be read (Input/output error)");
    }
}

TEST(TextFile, ThatShrinksWhileItIsReadIsRefused) {
    std::istringstream whole("12345"), cut("1234"), unknown("1234"), grown("123456");
    EXPECT_EQ(read_text_stream(whole, 5, "notes.txt"), "12345");
    EXPECT_EQ(read_text_stream(unknown, 0, "notes.txt"), "1234");
    EXPECT_EQ(read_text_stream(grown, 5, "notes.txt"), "123456");
    const InputError error = error_of(cut, 5);
    EXPECT_EQ(error.problem(), "ended after 4 of 5 bytes: it was cut while it was read");
    EXPECT_EQ(error.place(), "notes.txt");
}

// Files of /proc say that they have no bytes.
TEST(TextFile, ThatDoesNotKnowItsSizeIsReadWhole) {
    const std::filesystem::path file = "/proc/self/stat";
    if (!std::filesystem::exists(file)) GTEST_SKIP() << "no " << file;
    EXPECT_FALSE(read_text_file(file, "").empty());
}

std::string nested(int deep) {
    const auto count = static_cast<std::size_t>(deep);
    return std::string(count, '[') + std::string(count, ']');
}

// Brackets in texts nest nothing; a quotation mark behind a backslash ends no text.
TEST(TextFile, ThatNestsDeeperThanARecursionBearsIsRefused) {
    const TemporaryFolder folder;
    const std::filesystem::path file = folder.path() / "a.json";
    const std::string brackets(1000, '[');
    for (const std::string& good : {nested(deepest_json), "[\"" + brackets + "\"]",
                                    "{\"\\\"" + brackets + "\": 1}", "(" + brackets}) {
        std::ofstream(file, std::ios::binary) << good;
        EXPECT_EQ(read_text_file(file, "Give a letter"), good);
    }
    for (const std::string& bad : {nested(deepest_json + 1), "\xef\xbb\xbf \n" + brackets,
                                   "{\"a\": " + brackets, "[\"\\\\\"," + brackets}) {
        std::ofstream(file, std::ios::binary) << bad;
        EXPECT_EQ(problem_of(file), "nests lists and objects deeper than any file of this program")
            << bad;
    }
}

}  // namespace
}  // namespace hepatica
