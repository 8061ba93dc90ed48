// SPDX-License-Identifier: GPL-3.0-or-later
// The documents speak of what is there: every file, folder and picture that they name exists.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <string>

namespace {

namespace fs = std::filesystem;

const fs::path source_root = HEPATICA_SOURCE_DIR;

std::string text_of(const fs::path& file) {
    std::ifstream in(file);
    return {std::istreambuf_iterator<char>(in), {}};
}

std::set<fs::path> documents() {
    std::set<fs::path> found;
    for (const fs::path& folder : {source_root, source_root / "docs", source_root / "packaging"})
        for (const auto& entry : fs::directory_iterator(folder))
            if (entry.path().extension() == ".md") found.insert(entry.path());
    return found;
}

// Paths of this tree between backquotes; `core/deform/stepper.*` names all that begin like this.
std::set<std::string> paths_named_in(const std::string& text) {
    static const std::regex pattern(
        "`((?:core|gpu|render|ui|app|tests|scripts|cmake|assets|bench|packaging)/[A-Za-z0-9_./"
        "*-]*)`");
    std::set<std::string> paths;
    for (std::sregex_iterator match(text.begin(), text.end(), pattern), end; match != end; ++match)
        paths.insert((*match)[1]);
    return paths;
}

std::set<std::string> links_in(const std::string& text) {
    static const std::regex pattern(R"(\]\(([^)#:]+)\))");
    std::set<std::string> links;
    for (std::sregex_iterator match(text.begin(), text.end(), pattern), end; match != end; ++match)
        links.insert((*match)[1]);
    return links;
}

bool is_there(const std::string& path) {
    const std::size_t star = path.find('*');
    if (star == std::string::npos) return fs::exists(source_root / path);
    const fs::path folder = (source_root / path.substr(0, star)).parent_path();
    const std::string stem = fs::path(path.substr(0, star)).filename().string();
    if (!fs::is_directory(folder)) return false;
    for (const auto& entry : fs::directory_iterator(folder))
        if (entry.path().filename().string().starts_with(stem)) return true;
    return false;
}

TEST(Documents, NameOnlyFilesThatExist) {
    int checked = 0;
    for (const fs::path& document : documents())
        for (const std::string& path : paths_named_in(text_of(document))) {
            EXPECT_TRUE(is_there(path)) << document.filename() << " names " << path;
            ++checked;
        }
    EXPECT_GT(checked, 50) << "no documents were found at " << source_root;
}

TEST(Documents, LinkOnlyToWhatExists) {
    for (const fs::path& document : documents())
        for (const std::string& link : links_in(text_of(document)))
            EXPECT_TRUE(fs::exists(document.parent_path() / link))
                << document.filename() << " links to " << link;
}

TEST(Documents, TheCheckItselfObjects) {
    EXPECT_EQ(paths_named_in("see `core/cellar/wine.h` and `bin/x`"),
              std::set<std::string>{"core/cellar/wine.h"});
    EXPECT_FALSE(is_there("core/cellar/wine.h"));
    EXPECT_FALSE(is_there("core/base/wine.*"));
    EXPECT_TRUE(is_there("core/base/error.*"));
    EXPECT_EQ(links_in("[a](docs/b.md) [c](https://d)"), std::set<std::string>{"docs/b.md"});
}

}  // namespace
