// SPDX-License-Identifier: GPL-3.0-or-later
// The readers are fuzzed with clang 14 on the standard library of GCC 12: what these two cannot
// compile together must not stand in core, or the fuzzers no longer build.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <string>

namespace {

namespace fs = std::filesystem;

// Views, and algorithms that return a subrange.
const std::regex beyond_clang_14(
    R"(std::(views|ranges::(unique|remove|remove_if|rotate|partition|stable_partition|search|equal_range|subrange|find_end)\b))");

TEST(Compilers, CoreHasNothingThatTheFuzzersCannotCompile) {
    int files = 0;
    for (const auto& entry :
         fs::recursive_directory_iterator(fs::path(HEPATICA_SOURCE_DIR) / "core")) {
        if (entry.path().extension() != ".h" && entry.path().extension() != ".cpp") continue;
        std::ifstream in(entry.path());
        const std::string text{std::istreambuf_iterator<char>(in), {}};
        EXPECT_FALSE(std::regex_search(text, beyond_clang_14)) << entry.path();
        ++files;
    }
    EXPECT_GT(files, 300);
    EXPECT_TRUE(std::regex_search("a.erase(std::ranges::unique(a).begin())", beyond_clang_14));
    EXPECT_FALSE(std::regex_search("std::ranges::sort(a)", beyond_clang_14));
}

}  // namespace
