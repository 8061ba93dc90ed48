// SPDX-License-Identifier: GPL-3.0-or-later
// What a person can give by mistake, given to the real program: refused with exit code 1, a message
// that names the culprit, and no files left.
#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "core/base/hash.h"
#include "core/base/job.h"
#include "core/image/volume_writer.h"
#include "tests/app/run_program.h"

namespace hepatica {
namespace {

namespace fs = std::filesystem;
using test::Outcome;
using test::run_cli;

class BadInput : public testing::Test {
  protected:
    void SetUp() override {
        fs::remove_all(folder_);
        fs::create_directories(folder_);
    }
    void TearDown() override { fs::remove_all(folder_); }

    std::set<fs::path> files() const {
        std::set<fs::path> found;
        for (const auto& entry : fs::recursive_directory_iterator(folder_))
            found.insert(entry.path());
        return found;
    }
    // Reconstructs, expects the refusal, and expects the folder to be as it was.
    Outcome refused(std::vector<std::string> arguments, const test::RunLimits& limits = {}) const {
        const std::set<fs::path> before = files();
        arguments.insert(arguments.begin(), "reconstruct");
        arguments.insert(arguments.end(), {"--out", (folder_ / "p.hep").string(), "--json"});
        const Outcome run = run_cli(arguments, limits);
        EXPECT_EQ(run.exit_code, 1) << run.errors;
        EXPECT_EQ(run.output, "");
        EXPECT_NE(run.errors.find("error: "), std::string::npos);
        EXPECT_EQ(files(), before);
        return run;
    }
    std::string path(const char* name) const { return (folder_ / name).string(); }

    // A small CT with a bright tube in soft tissue.
    static Volume small_ct() {
        Grid grid;
        grid.dims = {40, 36, 32};
        grid.spacing_mm = Vec3(1.0, 1.0, 1.5);
        Volume ct(grid, 100);
        for (int z = 0; z < 32; ++z)
            for (int y = 14; y < 20; ++y)
                for (int x = 16; x < 22; ++x) ct.at(x, y, z) = 180;
        return ct;
    }

    fs::path folder_ = fs::path(testing::TempDir()) / "hepatica bad input";
};

TEST_F(BadInput, NoSuchFile) {
    EXPECT_NE(refused({path("nö")}).errors.find("nö"), std::string::npos);
}

TEST_F(BadInput, AnEmptyFolder) {
    fs::create_directories(folder_ / "empty");
    EXPECT_NE(refused({path("empty")}).errors.find("empty"), std::string::npos);
}

TEST_F(BadInput, ATextFileNamedNii) {
    std::ofstream(folder_ / "text.nii") << "Dear sir or madam";
    EXPECT_NE(refused({path("text.nii")}).errors.find("text.nii"), std::string::npos);
}

TEST_F(BadInput, ADicomSeriesWithASliceMissing) {
    Job job;
    write_dicom_series(folder_ / "ct", small_ct(), {}, job);
    fs::remove(folder_ / "ct" / "slice_0016.dcm");
    const Outcome run = refused({path("ct")});
    EXPECT_NE(run.errors.find("missing"), std::string::npos) << run.errors;
}

TEST_F(BadInput, AHeaderThatClaimsAHundredThousandSlices) {
    write_nifti(folder_ / "ct.nii", small_ct());
    std::fstream file(folder_ / "ct.nii", std::ios::in | std::ios::out | std::ios::binary);
    const std::int16_t dims[4] = {3, 512, 512, 32767};
    file.seekp(40);  // dim[] of the NIfTI-1 header; 32767 is the largest it can claim
    file.write(reinterpret_cast<const char*>(dims), sizeof dims);
    file.close();
    EXPECT_NE(refused({path("ct.nii")}).errors.find("ct.nii"), std::string::npos);

    std::ofstream(folder_ / "ct.mha", std::ios::binary)
        << "ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = False\n"
           "DimSize = 512 512 100000\nElementSpacing = 1 1 1\nElementType = MET_SHORT\n"
           "ElementDataFile = LOCAL\n"
        << std::string(1000, '\0');
    EXPECT_NE(refused({path("ct.mha")}).errors.find("100000"), std::string::npos);
}

TEST_F(BadInput, AnAllZeroVolume) {
    Volume ct = small_ct();
    std::fill(ct.voxels.begin(), ct.voxels.end(), std::int16_t{0});
    write_nifti(folder_ / "zero.nii.gz", ct);
    EXPECT_NE(refused({path("zero.nii.gz")}).errors.find("zero.nii.gz"), std::string::npos);
}

TEST_F(BadInput, VoxelsOfAnotherUnit) {
    for (const auto& [spacing_mm, said] :
         {std::pair<double, std::string>{0.01, "0.01 mm"}, {50.0, "50 mm"}}) {
        Volume ct = small_ct();
        ct.grid.spacing_mm.z() = spacing_mm;
        write_nifti(folder_ / "ct.nii.gz", ct);
        const Outcome run = refused({path("ct.nii.gz")});
        EXPECT_NE(run.errors.find(said + " along z"), std::string::npos) << run.errors;
        EXPECT_NE(run.errors.find("export it again in millimetres"), std::string::npos);
    }
}

// Where the scan cannot be used, what was odd about its values stands beside the reason.
TEST_F(BadInput, ValuesThatAreNoNumbersAreCounted) {
    const Volume ct = small_ct();
    FloatVolume values(ct.grid);
    for (std::size_t i = 0; i < ct.voxels.size(); ++i)
        values.voxels[i] = i % 50 == 0 ? std::numeric_limits<float>::quiet_NaN() : 100.0f;
    write_nifti(folder_ / "ct.nii.gz", values);
    const Outcome run = refused({path("ct.nii.gz")});
    const std::size_t missing = (ct.voxels.size() + 49) / 50;
    EXPECT_NE(run.errors.find(std::to_string(missing) + " of " + std::to_string(ct.voxels.size()) +
                              " values are not numbers"),
              std::string::npos)
        << run.errors;
}

TEST_F(BadInput, SeedsOutsideTheImageOrFarFromTheLiverAreRefusedBeforeSegmenting) {
    write_nifti(folder_ / "ct.nii.gz", small_ct());
    Mask liver(small_ct().grid);
    for (int z = 0; z < 32; ++z)
        for (int y = 0; y < 36; ++y)
            for (int x = 0; x < 12; ++x) liver.at(x, y, z) = 1;
    write_nifti(folder_ / "liver.nii.gz", liver);
    const Vec3 beside = liver.grid.to_mm(38, 18, 16);
    const std::string far = std::to_string(beside.x()) + "," + std::to_string(beside.y()) + "," +
                            std::to_string(beside.z());
    for (const auto& [seed, said] :
         {std::pair<std::string, std::string>{"9000,0,0", "image"}, {far, "liver.nii.gz"}}) {
        const Outcome run =
            refused({path("ct.nii.gz"), "--liver-mask", path("liver.nii.gz"), "--seed-mm=" + seed});
        EXPECT_NE(run.errors.find("--seed-mm"), std::string::npos) << run.errors;
        EXPECT_NE(run.errors.find(said), std::string::npos) << run.errors;
        EXPECT_EQ(run.errors.find("] Resampling"), std::string::npos) << run.errors;
    }
}

TEST_F(BadInput, AMaskThatDoesNotLieOnTheVoxelsOfTheImage) {
    write_nifti(folder_ / "ct.nii.gz", small_ct());
    Grid larger = small_ct().grid;
    larger.dims = {100, 10, 10};
    Grid finer = small_ct().grid;
    finer.dims = {10, 10, 10};
    finer.spacing_mm *= 0.7;
    for (const Grid& other : {larger, finer}) {
        write_nifti(folder_ / "mask.nii.gz", Mask(other, 1));
        for (const char* option : {"--liver-mask", "--vessel-mask"})
            EXPECT_NE(
                refused({path("ct.nii.gz"), option, path("mask.nii.gz")}).errors.find("mask.nii"),
                std::string::npos);
    }
}

TEST_F(BadInput, AnOutputThatCannotBeWritten) {
    write_nifti(folder_ / "ct.nii.gz", small_ct());
    for (const std::string& out :
         {path("ct.nii.gz") + "/p.hep", std::string("/proc/p.hep"), folder_.string()}) {
        const std::set<fs::path> before = files();
        const Outcome run = run_cli({"reconstruct", path("ct.nii.gz"), "--out", out});
        EXPECT_EQ(run.exit_code, 1) << out << run.errors;
        EXPECT_EQ(files(), before);
    }
}

// A CT with a drawn vessel, and what to call to reconstruct it.
class Reconstruction : public BadInput {
  protected:
    void SetUp() override {
        BadInput::SetUp();
        write_nifti(folder_ / "ct.nii.gz", small_ct());
        Mask vessels(small_ct().grid);
        for (int z = 2; z < 30; ++z)
            for (int y = 14; y < 20; ++y)
                for (int x = 16; x < 22; ++x) vessels.at(x, y, z) = 1;
        write_nifti(folder_ / "vessels.nii.gz", vessels);
    }
    std::vector<std::string> arguments() const {
        return {"reconstruct",          path("ct.nii.gz"), "--vessel-mask",
                path("vessels.nii.gz"), "--out",           path("p.hep")};
    }
};

TEST_F(Reconstruction, LeavesNothingWhereAFileCannotGrow) {
    // Limits below the size of the smallest and of larger files of the case.
    const std::set<fs::path> before = files();
    for (const long bytes : {0L, 300L, 2000L, 8000L}) {
        const Outcome run = run_cli(arguments(), {.file_bytes = bytes});
        EXPECT_EQ(run.exit_code, 1) << bytes << ": " << run.errors;
        EXPECT_EQ(files(), before) << bytes;
    }
    const Outcome run = run_cli(arguments());
    EXPECT_EQ(run.exit_code, 0) << run.errors;
}

TEST_F(Reconstruction, InterruptedInAnyStageKeepsTheOlderCaseWhole) {
    ASSERT_EQ(run_cli(arguments()).exit_code, 0);
    const std::set<fs::path> before = files();
    std::map<fs::path, std::uint64_t> hashes;
    for (const fs::path& file : before)
        if (fs::is_regular_file(file)) hashes[file] = hash_of_file(file);
    int interrupted = 0;
    for (const char* stage : {"[1/", "[2/", "[3/", "[4/", "[5/", "[6/", "[7/"}) {
        const Outcome run = run_cli(arguments(), {.interrupt_at = stage});
        // A stage may end before the signal comes; then the case is replaced, by the same bytes.
        EXPECT_TRUE(run.exit_code == 130 || run.exit_code == 0) << stage << run.errors;
        interrupted += run.exit_code == 130 ? 1 : 0;
        EXPECT_EQ(files(), before) << stage;
        for (const auto& [file, hash] : hashes) EXPECT_EQ(hash_of_file(file), hash) << file;
    }
    EXPECT_GT(interrupted, 0);
}

// As by nohup, or of a job in a script's background: somebody else's Ctrl-C is not its own.
TEST_F(Reconstruction, GoesOnThroughASignalThatItWasStartedToIgnore) {
    for (const int number : {SIGINT, SIGHUP}) {
        const Outcome run =
            run_cli(arguments(), {.interrupt_at = "[1/", .signal = number, .ignored = true});
        EXPECT_EQ(run.exit_code, 0) << number << ": " << run.errors;
        EXPECT_TRUE(fs::exists(folder_ / "p.hep" / "case.json")) << number;
        fs::remove_all(folder_ / "p.hep");
    }
}

TEST_F(BadInput, ADamagedScriptCaseAndRecording) {
    std::ofstream(folder_ / "text") << "not JSON";
    for (const std::vector<std::string>& arguments :
         {std::vector<std::string>{"simulate", path("none.hep"), "--script", path("text")},
          {"replay", path("text")},
          {"scene", path("text")},
          {"scene", path("none.json")},
          {"compare", path("none.hep"), "--truth-tree", path("text"), "--truth-mask",
           path("text")}}) {
        const Outcome run = run_cli(arguments);
        EXPECT_EQ(run.exit_code, 1) << arguments[0] << run.errors;
        EXPECT_EQ(run.output, "");
    }
}

// What follows an option's value is not taken for another one.
TEST_F(BadInput, ACtAfterAnOptionIsTheCt) {
    for (std::vector<std::string> arguments :
         {std::vector<std::string>{"--seed-mm", "1,2,3"},
          {"--window", "100,200"},
          {"--tumour-mask", path("tumours")},
          {"--liver-mask", path("liver"), "--liver-label", "5,6"},
          {"--vessel-mask", path("vessels"), "--vessel-label", "1=portal,2=hepatic"}}) {
        arguments.push_back(path("the CT"));
        const Outcome run = refused(arguments);
        EXPECT_NE(run.errors.find(path("the CT")), std::string::npos) << run.errors;
    }
}

TEST_F(BadInput, WhatIsNotThereIsSaidNotToBeThere) {
    for (const std::vector<std::string>& arguments :
         {std::vector<std::string>{"render", path("no such.hep"), "--out", path("a.png")},
          {"copy", path("no such.hepz"), "--out", path("a.hep")},
          {"replay", path("no such.hrec")},
          {"lesson", "gentle_pull", "--recording", path("no such.hrec")}}) {
        const Outcome run = run_cli(arguments);
        EXPECT_EQ(run.exit_code, 1) << arguments[0] << run.errors;
        EXPECT_NE(run.errors.find("no such.h"), std::string::npos) << run.errors;
        EXPECT_NE(run.errors.find("does not exist"), std::string::npos) << run.errors;
    }
}

TEST_F(BadInput, APhantomCancelledInAnyStageLeavesNothing) {
    const std::vector<std::string> adult{"phantom",     path("p"),   "--dims",
                                         "256,256,160", "--spacing", "0.8,0.8,1.0"};
    const Outcome whole = run_cli(adult);
    ASSERT_EQ(whole.exit_code, 0) << whole.errors;
    fs::remove_all(folder_ / "p");
    constexpr int stages = 5;  // what is over in an instant is not always announced
    int interrupted = 0;
    for (int stage = 1; stage <= stages; ++stage) {
        const Outcome run = run_cli(adult, {.interrupt_at = "info: [" + std::to_string(stage)});
        // A stage may end before the signal comes; then the patient is there as a whole.
        ASSERT_TRUE(run.exit_code == 130 || run.exit_code == 0) << run.errors;
        if (run.exit_code == 0) {
            EXPECT_TRUE(fs::exists(folder_ / "p" / "truth_tree.vtp"));
            fs::remove_all(folder_ / "p");
            continue;
        }
        ++interrupted;
        EXPECT_TRUE(files().empty()) << stage;
    }
    EXPECT_GE(interrupted, 2);
}

// Limits below a slice's header, amid it, and amid its pixels.
TEST_F(BadInput, APhantomThatFindsTheDiskFullLeavesNothing) {
    for (const long bytes : {0L, 300L, 1000L, 2000L}) {
        const Outcome run = run_cli({"phantom", path("p"), "--dims", "32,32,32", "--spacing",
                                     "5,5,5", "--generations", "1"},
                                    {.file_bytes = bytes});
        EXPECT_EQ(run.exit_code, 1) << bytes << ": " << run.errors;
        EXPECT_TRUE(files().empty()) << bytes;
        if (bytes < 2000) continue;  // then its message is cut off, too
        EXPECT_NE(run.errors.find(path("p/ct/slice_0001.dcm")), std::string::npos) << run.errors;
    }
}

// Killed at once it would leave its temporary folder.
TEST_F(BadInput, APhantomWhoseTerminalIsClosedLeavesNothing) {
    const Outcome run =
        run_cli({"phantom", path("p"), "--dims", "256,256,160", "--spacing", "0.8,0.8,1.0"},
                {.interrupt_at = "info: [2", .signal = SIGHUP});
    EXPECT_EQ(run.exit_code, 130) << run.errors;
    EXPECT_TRUE(files().empty());
}

TEST_F(BadInput, WhatIsNoNumber) {
    write_nifti(folder_ / "ct.nii.gz", small_ct());
    for (const std::vector<std::string>& arguments :
         {std::vector<std::string>{"reconstruct", path("ct.nii.gz"), "--seed-mm", "nan,1,1",
                                   "--out", path("p.hep")},
          {"reconstruct", path("ct.nii.gz"), "--spacing-mm", "nan", "--out", path("p.hep")},
          {"reconstruct", path("ct.nii.gz"), "--out", path("p.hep"), "--spacing-mm=-NaN"},
          {"reconstruct", path("ct.nii.gz"), "--out", path("p.hep"), "--window", "100,inf"},
          {"simulate", path("none.hep"), "--script", path("none.json"), "--dt-s", "nan"}}) {
        const Outcome run = run_cli(arguments);
        EXPECT_EQ(run.exit_code, 2) << arguments.back();
        EXPECT_NE(run.errors.find("number"), std::string::npos) << run.errors;
    }
}

// Ctrl-C reaches both processes, and the one that makes the patient ends first.
TEST_F(BadInput, ABenchmarkIsInterruptedWhileItsPatientIsMade) {
    const Outcome run = run_cli({"bench", "reconstruct", "--dims", "256,256,160", "--spacing",
                                 "0.8,0.8,1.0", "--out", path("bench")},
                                {.interrupt_at = "a synthetic patient is made"});
    EXPECT_EQ(run.exit_code, 130) << run.errors;
    EXPECT_EQ(run.errors.find("could not be made"), std::string::npos) << run.errors;
}

// Nan is a given name, and Infinity may be the name of a file: what is refused is the missing file.
TEST_F(BadInput, ANameMayReadAsANumber) {
    for (const std::vector<std::string>& arguments :
         {std::vector<std::string>{"reconstruct", path("none"), "--out", path("p.hep"), "--name",
                                   "Nan"},
          {"reconstruct", path("none"), "--out", path("p.hep"), "--name=inf"},
          {"scene", "Infinity"}}) {
        const Outcome run = run_cli(arguments);
        EXPECT_EQ(run.exit_code, 1) << run.errors;
        EXPECT_EQ(run.errors.find("no number that can be used"), std::string::npos) << run.errors;
    }
}

TEST_F(BadInput, ACaseThatIsNotThereIsNotMade) {
    const Outcome run = run_cli({"dial", path("none.hep"), "--budget", "1"});
    EXPECT_EQ(run.exit_code, 1) << run.errors;
    EXPECT_NE(run.errors.find("does not exist"), std::string::npos) << run.errors;
    EXPECT_EQ(run.errors.find("is made"), std::string::npos) << run.errors;
}

TEST_F(BadInput, AFolderInPlaceOfAFile) {
    for (const std::vector<std::string>& arguments :
         {std::vector<std::string>{"scene", path(".")},
          {"inject", path("none.vtp")},
          {"compare", path("none.hep"), "--truth-tree", path("none"), "--truth-mask", path("none")},
          {"extremes", "--filter", "no row is called so"}}) {
        const Outcome run = run_cli(arguments);
        EXPECT_EQ(run.exit_code, 1) << arguments[0] << run.errors;
    }
}

TEST(BadUsage, ExitsWithTwoAndSaysWhereHelpIs) {
    for (const std::vector<std::string>& arguments :
         {std::vector<std::string>{},
          {"fly"},
          {"reconstruct"},
          {"phantom", "x", "--dims", "1,2"},
          {"phantom", "x", "--format", "jpeg"},
          {"simulate", "x", "--script", "y", "--steps", "0"}}) {
        const Outcome run = run_cli(arguments);
        EXPECT_EQ(run.exit_code, 2) << run.errors;
        EXPECT_EQ(run.output, "");
    }
    EXPECT_EQ(run_cli({"--help"}).exit_code, 0);
    EXPECT_EQ(run_cli({"reconstruct", "--help"}).exit_code, 0);
    EXPECT_NE(run_cli({"fly"}).errors.find("fly"), std::string::npos);
}

TEST(BadUsage, OfAVerbInAGroupIsToldOfThatVerb) {
    for (const auto& [call, said, help] :
         {std::tuple<std::vector<std::string>, std::string, std::string>{
              {"bench", "nosuch"}, "there is no verb \"bench nosuch\"", "cli bench --help"},
          {{"bench", "step", "--bogus"}, "--bogus", "cli bench step --help"},
          {{"bench"}, "subcommand", "cli bench --help"},
          {{"fly", "step"}, "there is no verb \"fly\"", "cli --help"}}) {
        const Outcome run = run_cli(call);
        EXPECT_EQ(run.exit_code, 2) << run.errors;
        EXPECT_NE(run.errors.find(said), std::string::npos) << run.errors;
        EXPECT_NE(run.errors.find(help), std::string::npos) << run.errors;
    }
}

// It would stand in a report that says that it is UTF-8, and in a case, which cannot hold it.
TEST(BadUsage, ANameThatIsNoTextIsRefused) {
    for (const std::vector<std::string>& call :
         {std::vector<std::string>{"play", "none.hep", "--name", "x\xff"},
          {"reconstruct", "none", "--out", "none.hep", "--name", "x\xff"}}) {
        const Outcome run = run_cli(call);
        EXPECT_EQ(run.exit_code, 2) << call[0] << ": " << run.errors;
        EXPECT_NE(run.errors.find("--name: is no text in UTF-8"), std::string::npos) << run.errors;
    }
}

TEST_F(BadInput, AScriptWithAKeyTwiceIsRefused) {
    std::ofstream(folder_ / "s.json")
        << R"({"actions": [{"at_s": 0, "do": "release"}], "actions": []})";
    const Outcome run = run_cli({"simulate", path("none.hep"), "--script", path("s.json")});
    EXPECT_EQ(run.exit_code, 1) << run.errors;
    EXPECT_NE(run.errors.find("actions is given twice"), std::string::npos) << run.errors;
}

TEST_F(BadInput, ALinkToItselfIsNoPlaceToWriteTo) {
    fs::create_symlink("loop.csv", folder_ / "loop.csv");
    const Outcome run = run_cli({"inject", path("none.vtp"), "--csv", path("loop.csv")});
    EXPECT_EQ(run.exit_code, 1) << run.errors;
    EXPECT_NE(run.errors.find("loop.csv: "), std::string::npos) << run.errors;
    EXPECT_NE(run.errors.find("circle of links"), std::string::npos) << run.errors;
}

// As of a share that is not mounted: said before the work, which would be lost at its end.
TEST_F(BadInput, ALinkIntoAFolderThatIsNotThereIsNoPlaceToWriteTo) {
    fs::create_symlink(folder_ / "no share" / "x.csv", folder_ / "away.csv");
    const Outcome run = run_cli({"inject", path("none.vtp"), "--csv", path("away.csv")});
    EXPECT_EQ(run.exit_code, 1) << run.errors;
    EXPECT_NE(run.errors.find(path("no share/x.csv") + ": cannot be written"), std::string::npos)
        << run.errors;
}

}  // namespace
}  // namespace hepatica
