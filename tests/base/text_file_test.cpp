// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/text_file.h"

#include <gtest/gtest.h>

#include <fstream>

#include "core/base/error.h"
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

}  // namespace
}  // namespace hepatica
