// SPDX-License-Identifier: GPL-3.0-or-later
// Every file of tests is built: a test that no list names passes for ever.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& file) {
    std::ifstream in(file);
    return {std::istreambuf_iterator<char>(in), {}};
}

// Whether the list of the file's folder, or of one above it within `tests`, names it.
bool is_listed(const fs::path& file, const fs::path& tests) {
    for (fs::path folder = file.parent_path(); folder != tests; folder = folder.parent_path()) {
        const std::string name = file.lexically_relative(folder).generic_string();
        const std::string list = text_of(folder / "CMakeLists.txt");
        for (std::size_t at = list.find(name); at != std::string::npos;
             at = list.find(name, at + 1))
            if (at == 0 || std::string(" \n\t(:").find(list[at - 1]) != std::string::npos)
                return true;
    }
    return false;
}

TEST(TestFiles, AreAllBuilt) {
    const fs::path tests = fs::path(HEPATICA_SOURCE_DIR) / "tests";
    int files = 0;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(tests)) {
        if (!entry.path().filename().string().ends_with("_test.cpp")) continue;
        ++files;
        EXPECT_TRUE(is_listed(entry.path(), tests)) << entry.path() << " is in no CMakeLists.txt";
    }
    EXPECT_GT(files, 100);
}

}  // namespace
