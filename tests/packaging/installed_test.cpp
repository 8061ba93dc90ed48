// SPDX-License-Identifier: GPL-3.0-or-later
// What is installed, wherever that is: the programs, their files, and what a desktop reads of them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <set>
#include <string>

#include "tests/support/shell.h"

namespace hepatica {
namespace {

namespace fs = std::filesystem;

class Installed : public testing::Test {
  protected:
    static void SetUpTestSuite() {
        prefix = fs::path(testing::TempDir()) / ("installed here " + std::to_string(getpid()));
        const test::ShellAnswer answer =
            test::shell("cmake --install '" HEPATICA_BUILD "' --prefix '" + prefix.string() + "'");
        ASSERT_EQ(answer.exit_code, 0) << answer.output;
    }
    static void TearDownTestSuite() { fs::remove_all(prefix); }

    static fs::path prefix;
};
fs::path Installed::prefix;

TEST_F(Installed, EveryFileIsWhereItBelongs) {
    const std::string id = "org.hepatica.Hepatica";
    for (const std::string& file :
         {std::string("bin/hepatica"), std::string("bin/hepatica-cli"),
          std::string("libexec/hepatica/hepatica-dicom-frames"),
          std::string("libexec/hepatica/hepatica-dicom-segmentation"),
          std::string("share/hepatica/scripts/drag.json"), "share/applications/" + id + ".desktop",
          "share/metainfo/" + id + ".metainfo.xml", "share/mime/packages/" + id + ".xml",
          std::string("share/icons/hicolor/scalable/apps/hepatica.svg"),
          std::string("share/icons/hicolor/48x48/apps/hepatica.png"),
          std::string("share/man/man1/hepatica.1.gz"),
          std::string("share/man/man1/hepatica-cli.1.gz"),
          std::string("share/doc/hepatica/copyright"),
          std::string("share/doc/hepatica/changelog.gz")})
        EXPECT_TRUE(fs::is_regular_file(prefix / file)) << file;
}

TEST_F(Installed, NothingElseIsInstalledThanProgramsAndTheirFiles) {
    std::set<std::string> folders;
    for (const auto& entry : fs::directory_iterator(prefix))
        folders.insert(entry.path().filename().string());
    EXPECT_THAT(folders, testing::ElementsAre("bin", "libexec", "share"));
}

// With a file that is no case it gets as far as reading that; a script that is missing comes later.
TEST_F(Installed, TheProgramRunsFromWhereItWasPut) {
    const test::ShellAnswer answer =
        test::shell("cd / && '" + (prefix / "bin/hepatica-cli").string() + "' diagnose --json");
    EXPECT_EQ(answer.exit_code, 0) << answer.output;
    EXPECT_THAT(answer.output,
                testing::HasSubstr("\"files\": \"" + (prefix / "share/hepatica").string()));
}

// As the house does of its own formatting: icons are what their source says.
TEST(Icons, AreRenderedFromTheirSource) {
    if (test::shell("command -v rsvg-convert").exit_code != 0)
        GTEST_SKIP() << "rsvg-convert (package librsvg2-bin) is not installed";
    const fs::path copy = fs::path(testing::TempDir()) / ("icons " + std::to_string(getpid()));
    fs::copy(HEPATICA_PACKAGING "/icons", copy, fs::copy_options::recursive);
    EXPECT_EQ(test::shell("'" + (copy / "render").string() + "'").exit_code, 0);
    const test::ShellAnswer answer =
        test::shell("diff -r '" HEPATICA_PACKAGING "/icons' '" + copy.string() + "'");
    EXPECT_EQ(answer.exit_code, 0) << answer.output << "run packaging/icons/render";
    fs::remove_all(copy);
}

}  // namespace
}  // namespace hepatica
