// SPDX-License-Identifier: GPL-3.0-or-later
// The program's own files are found wherever program and files were moved together.
#include "core/base/program_files.h"

#include <gtest/gtest.h>

#include <fstream>

#include "core/base/error.h"

namespace hepatica {
namespace {

namespace fs = std::filesystem;

class ProgramFiles : public testing::Test {
  protected:
    void SetUp() override { fs::remove_all(root_); }
    void TearDown() override { fs::remove_all(root_); }

    fs::path made(const fs::path& below_root) {
        fs::create_directories((root_ / below_root).parent_path());
        std::ofstream(root_ / below_root) << "{}";
        return root_ / below_root;
    }

    const fs::path root_ =
        fs::path(testing::TempDir()) /
        ("program files " +
         std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
};

TEST_F(ProgramFiles, StandBesideTheInstalledProgram) {
    const fs::path file = made("usr/share/hepatica/scripts/a.json");
    EXPECT_EQ(asset_of(root_ / "usr/bin/hepatica", "scripts/a.json"), file);
    EXPECT_EQ(asset_of(root_ / "usr/bin/hepatica", "scripts"), file.parent_path());
}

TEST_F(ProgramFiles, StandInTheSourceTreeOfAProgramThatWasBuiltThere) {
    const fs::path file = made("assets/scripts/a.json");
    EXPECT_EQ(asset_of(root_ / "build/release/bin/hepatica", "scripts/a.json"), file);
}

TEST_F(ProgramFiles, HelpersStandInLibexecOrBesideTheProgram) {
    const fs::path built = made("usr/bin/helper");
    EXPECT_EQ(helper_of(root_ / "usr/bin/hepatica", "helper"), built);
    const fs::path installed = made("usr/libexec/hepatica/helper");
    EXPECT_EQ(helper_of(root_ / "usr/bin/hepatica", "helper"), installed);
    EXPECT_THROW(helper_of(root_ / "usr/bin/hepatica", "another"), InputError);
}

TEST_F(ProgramFiles, ThatAreMissingAreNamed) {
    try {
        asset_of(root_ / "usr/bin/hepatica", "scripts/a.json");
        FAIL();
    } catch (const InputError& error) {
        EXPECT_EQ(error.place(), "scripts/a.json");
    }
}

TEST_F(ProgramFiles, OfThisVeryTreeAreFoundFromAnyWorkingFolder) {
    const fs::path before = fs::current_path();
    fs::current_path("/");
    EXPECT_TRUE(fs::exists(asset("scripts/drag.json")));
    fs::current_path(before);
}

}  // namespace
}  // namespace hepatica
