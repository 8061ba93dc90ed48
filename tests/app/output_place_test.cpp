// SPDX-License-Identifier: GPL-3.0-or-later
// Where the verbs write: a name that promises another format is refused, and a path of which more
// than the last folder is missing is taken for mistyped, by every verb alike.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "app/output_place.h"
#include "core/base/error.h"
#include "core/patient/case_digest.h"
#include "core/patient/patient_case.h"
#include "core/tree/files/tree_io.h"
#include "tests/app/tour.h"

namespace hepatica {
namespace {

namespace fs = std::filesystem;
using test::Outcome;
using test::run_cli;

class OutputPlace : public test::Tour {
  protected:
    // Every verb that writes, with `out` as what it is told to write.
    static std::vector<std::vector<std::string>> calls(const std::string& folder) {
        const std::string tree = path("p/truth_tree.vtp"),
                          drag = HEPATICA_ASSETS "/scripts/drag.json";
        return {{"phantom", folder, "--dims", "32,32,32", "--spacing", "5,5,5"},
                {"reconstruct", path("p/ct"), "--out", folder + ".hep"},
                {"edit", path("p.hep"), "--out", folder + ".hep"},
                {"play", path("p.hep"), "--out", folder},
                {"render", path("p.hep"), "--out", folder + ".png"},
                {"skeleton", path("p/truth_mask.nii.gz"), "--out", folder},
                {"tradeoff", "--out", folder},
                {"flow-curves", folder, "--format", "csv"},
                {"bench", "reconstruct", path("p/ct"), "--out", folder},
                {"inject", tree, "--csv", folder + ".csv"},
                {"inject", tree, "--lengths-csv", folder + ".csv"},
                {"inject", tree, "--svzerod", folder + ".json"},
                {"inject", tree, "--plot", folder + ".csv"},
                {"embolize", tree, "--csv", folder + ".csv"},
                {"embolize", tree, "--plot", folder + ".csv"},
                {"simulate", path("p.hep"), "--script", drag, "--record", folder + ".hrec"}};
    }
};

TEST_F(OutputPlace, OfWhichTwoFoldersAreMissingIsRefusedByEveryVerb) {
    for (const std::vector<std::string>& call : calls(path("mis/typed/name"))) {
        const Outcome run = run_cli(call);
        EXPECT_EQ(run.exit_code, 1) << call[0] << ": " << run.errors;
        EXPECT_NE(run.errors.find("there is no folder " + path("mis")), std::string::npos)
            << call[0] << ": " << run.errors;
        EXPECT_FALSE(fs::exists(path("mis"))) << call[0];
    }
}

TEST_F(OutputPlace, ItsLastFolderIsMadeAndNamed) {
    for (const std::vector<std::string>& call :
         {std::vector<std::string>{"inject", path("p/truth_tree.vtp"), "--csv", path("new/a.csv")},
          {"flow-curves", path("new/curves"), "--format", "csv"},
          {"edit", path("p.hep"), "--out", path("new/e.hep")}}) {
        const Outcome run = run_cli(call);
        EXPECT_EQ(run.exit_code, 0) << run.errors;
        EXPECT_NE(run.errors.find(path("new") + " is made"), std::string::npos) << run.errors;
        fs::remove_all(path("new"));
    }
}

TEST_F(OutputPlace, APictureIsNamedPng) {
    for (const char* name : {"a.jpg", "a.tiff", "a"}) {
        const Outcome run = run_cli({"render", path("p.hep"), "--out", path(name)});
        EXPECT_EQ(run.exit_code, 2) << name;
        EXPECT_NE(run.errors.find(path(name)), std::string::npos) << run.errors;
        EXPECT_NE(run.errors.find(".png"), std::string::npos) << run.errors;
        EXPECT_FALSE(fs::exists(path(name)));
    }
    EXPECT_EQ(
        run_cli({"render", path("p.hep"), "--size", "64,48", "--out", path("A.PNG")}).exit_code, 0);
}

TEST_F(OutputPlace, AFileIsNotNamedLikeAnother) {
    const std::string tree = path("p/truth_tree.vtp"), drag = HEPATICA_ASSETS "/scripts/drag.json";
    const std::vector<std::string> simulate{"simulate", path("p.hep"), "--script",
                                            drag,       "--steps",     "1"};
    const auto playing = [&](const std::string& option) {
        std::vector<std::string> call = simulate;
        call.push_back(option);
        return call;
    };
    for (std::vector<std::string> call :
         {std::vector<std::string>{"inject", tree, "--csv"},
          {"inject", tree, "--lengths-csv"},
          {"inject", tree, "--svzerod"},
          {"embolize", tree, "--csv"},
          playing("--record"),
          playing("--final-mesh"),
          playing("--steps-csv"),
          {"bench", "drag", path("p.hep"), "--no-error", "--motion", "pull", "--steps-csv"},
          {"train", "--volumes", "1", "--out"}}) {
        call.push_back(path("a.jpg"));
        const Outcome run = run_cli(call);
        EXPECT_EQ(run.exit_code, 2) << call[0] << ": " << run.errors;
        EXPECT_NE(run.errors.find(path("a.jpg")), std::string::npos) << run.errors;
        EXPECT_NE(run.errors.find("Name a file that ends in"), std::string::npos) << run.errors;
        EXPECT_FALSE(fs::exists(path("a.jpg"))) << call[0];
    }
}

// Before the work, which may take hours.
TEST_F(OutputPlace, AFolderIsNoFileToWrite) {
    for (const auto& [call, ending] : {std::pair<std::vector<std::string>, std::string>{
                                           {"inject", path("p/truth_tree.vtp"), "--csv"}, ".csv"},
                                       {{"inject", path("p/truth_tree.vtp"), "--plot"}, ".csv"},
                                       {{"render", path("p.hep"), "--out"}, ".png"},
                                       {{"export", path("p.hep"), "--out"}, ".seg.nrrd"},
                                       {{"train", "--volumes", "1", "--out"}, ".json"}}) {
        const std::string taken = path("folder" + ending);
        fs::create_directories(taken);
        std::vector<std::string> whole = call;
        whole.push_back(taken);
        const Outcome run = run_cli(whole);
        EXPECT_EQ(run.exit_code, 1) << call[0] << ": " << run.errors;
        EXPECT_NE(run.errors.find(taken + ": is a folder"), std::string::npos) << run.errors;
        EXPECT_EQ(run.errors.find("[1/"), std::string::npos) << run.errors;
    }
}

// What is in its place was replaced by a file, or waited for.
TEST_F(OutputPlace, APipeStaysAPipe) {
    const std::string pipe = path("pipe");
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    for (const auto& [call, said] :
         {std::pair<std::vector<std::string>, std::string>{
              {"inject", path("p/truth_tree.vtp"), "--csv", pipe}, "cannot be written"},
          {{"simulate", path("p.hep"), "--script", HEPATICA_ASSETS "/scripts/drag.json", "--steps",
            "1", "--record", pipe},
           "is a pipe, a socket or a device"}}) {
        const Outcome run = run_cli(call, {.seconds = 120});
        EXPECT_EQ(run.exit_code, 1) << call[0] << ": " << run.errors;
        EXPECT_NE(run.errors.find(pipe + ": " + said), std::string::npos) << run.errors;
        EXPECT_TRUE(fs::is_fifo(pipe)) << call[0];
    }
    fs::remove(pipe);
}

TEST_F(OutputPlace, ACaseIsNotNamedLikeAFile) {
    for (const char* name : {"x.txt", "x.nii.gz"})
        for (std::vector<std::string> call :
             {std::vector<std::string>{"reconstruct", path("p/ct")}, {"edit", path("p.hep")}}) {
            call.insert(call.end(), {"--out", path(name)});
            const Outcome run = run_cli(call);
            EXPECT_EQ(run.exit_code, 2) << call[0] << name;
            EXPECT_NE(run.errors.find(path(name)), std::string::npos) << run.errors;
            EXPECT_NE(run.errors.find(".hep"), std::string::npos) << run.errors;
            EXPECT_FALSE(fs::exists(path(name)));
        }
    for (const char* name : {"plain", "slash.hep/"}) {
        const Outcome run = run_cli({"edit", path("p.hep"), "--out", path(name)});
        EXPECT_EQ(run.exit_code, 0) << run.errors;
        EXPECT_TRUE(fs::exists(folder() / name / "case.json"));
    }
}

TEST_F(OutputPlace, TwoOutputsAreNotOneFile) {
    const std::string tree = path("p/truth_tree.vtp"), twice = path("twice.csv");
    write_tree(path("own.json"), read_tree(tree));
    const Outcome itself = run_cli({"inject", path("own.json"), "--svzerod", path("own.json")});
    EXPECT_EQ(itself.exit_code, 2) << itself.errors;
    EXPECT_EQ(read_tree(path("own.json")).segments.size(), read_tree(tree).segments.size());
    for (const std::vector<std::string>& call :
         {std::vector<std::string>{"inject", tree, "--csv", twice, "--lengths-csv", twice},
          {"inject", tree, "--csv", twice, "--plot", path("p/../twice.csv")},
          {"embolize", tree, "--csv", twice, "--plot", twice},
          {"simulate", path("p.hep"), "--script", path("s"), "--record", path("x"), "--steps-csv",
           path("x")},
          {"simulate", path("p.hep"), "--script", path("s"), "--record", path("s")},
          {"lesson", "gentle_pull", "--recording", path("play"), "--csv", path("play")}}) {
        const Outcome run = run_cli(call);
        EXPECT_EQ(run.exit_code, 2) << call[0] << ": " << run.errors;
        EXPECT_NE(run.errors.find("is named twice"), std::string::npos) << run.errors;
        EXPECT_FALSE(fs::exists(twice)) << call[0];
    }
}

// A slash too many makes no folder of a file.
TEST_F(OutputPlace, AFileIsNotReplacedByAFolder) {
    ASSERT_EQ(run_cli({"copy", path("p.hep"), "--out", path("one.hepz")}).exit_code, 0);
    for (const std::vector<std::string>& call :
         {std::vector<std::string>{"copy", path("p.hep"), "--out", path("one.hepz/")},
          {"phantom", path("one.hepz/"), "--dims", "32,32,32", "--spacing", "5,5,5"}}) {
        const Outcome run = run_cli(call);
        EXPECT_EQ(run.exit_code, 1) << call[0] << ": " << run.errors;
        EXPECT_NE(run.errors.find("is a file and no folder"), std::string::npos) << run.errors;
        EXPECT_TRUE(fs::is_regular_file(path("one.hepz"))) << call[0];
    }
}

// Said before the case is read, not when it is to be written.
TEST_F(OutputPlace, AnEmptyFolderIsRefusedBeforeTheWork) {
    for (const auto& [name, why] : {std::pair{"empty.hepz", "is a folder"},
                                    std::pair{"empty.hep", "is not a patient's case"}}) {
        fs::create_directory(path(name));
        const Outcome run = run_cli({"copy", path("p.hep"), "--out", path(name)});
        EXPECT_EQ(run.exit_code, 1) << run.errors;
        EXPECT_NE(run.errors.find(why), std::string::npos) << run.errors;
        EXPECT_NE(run.errors.find(path(name)), std::string::npos) << run.errors;
        EXPECT_EQ(run.errors.find("Reading the case"), std::string::npos) << run.errors;
        EXPECT_TRUE(fs::is_empty(path(name)));
    }
}

// Nobody's case goes by a name that was mistyped.
TEST_F(OutputPlace, ACaseOfAnotherPatientIsReplacedOnlyWhereThatIsSaid) {
    PatientCase other = read_case(path("p.hep"));
    other.source.image_sha256 = std::string(64, 'b');
    for (const char* name : {"other.hep", "other.hepz"}) {
        write_case(path(name), other);
        const std::string digest = digest_of_case(path(name));
        for (std::vector<std::string> call :
             {std::vector<std::string>{"copy", path("p.hep")},
              {"edit", path("p.hep")},
              {"remake", path("p.hep"), "--ct", path("p/ct"), "--paint", "0,0,0,2"},
              {"reconstruct", path("p/ct"), "--vessel-mask", path("p/truth_mask.nii.gz")}}) {
            call.insert(call.end(), {"--out", path(name)});
            const Outcome run = run_cli(call);
            EXPECT_EQ(run.exit_code, 1) << call[0] << ": " << run.errors;
            EXPECT_NE(run.errors.find(path(name) + ": holds a case already that is not known"),
                      std::string::npos)
                << call[0] << ": " << run.errors;
            EXPECT_EQ(digest_of_case(path(name)), digest) << call[0];
        }
        const std::vector<std::string> copy{"copy", path("p.hep"), "--out", path(name)};
        std::vector<std::string> replacing = copy;
        replacing.emplace_back("--replace");
        EXPECT_EQ(run_cli(replacing).exit_code, 0) << name;
        EXPECT_TRUE(is_case_of(path(name), read_case(path("p.hep")))) << name;
        EXPECT_EQ(run_cli(copy).exit_code, 0) << name << ": it is of the same patient by now";
    }
}

// What another program saved while a verb was at work stays.
TEST_F(OutputPlace, ACaseIsChangedInPlaceOnlyAsItWasRead) {
    write_case(path("shared.hep"), read_case(path("p.hep")));
    const std::string digest = digest_of_case(path("shared.hep"));
    EXPECT_NO_THROW(require_as_read(path("shared.hep"), digest));
    for (const fs::path& out :
         {fs::path(), fs::path(path("shared.hep")), fs::path(path("p.hep/../shared.hep"))})
        EXPECT_TRUE(is_in_place(out, path("shared.hep"))) << out;
    for (const char* out : {"p.hep", "new.hep"})
        EXPECT_FALSE(is_in_place(path(out), path("shared.hep"))) << out;
    PatientCase changed = read_case(path("p.hep"));
    changed.measured.push_back({.points_mm = {Vec3(1, 2, 3), Vec3(4, 5, 6)}});
    write_case(path("shared.hep"), changed);
    EXPECT_THROW(require_as_read(path("shared.hep"), digest), InputError);
    fs::remove_all(path("shared.hep"));
    EXPECT_THROW(require_as_read(path("shared.hep"), digest), InputError) << "it was moved away";
}

// A folder of one's own work is not replaced by a case.
TEST_F(OutputPlace, AFolderThatIsNoCaseIsNotReplacedByAnEditedOne) {
    const Outcome run = run_cli({"edit", path("p.hep"), "--out", path("p")});
    EXPECT_EQ(run.exit_code, 1) << run.errors;
    EXPECT_TRUE(fs::exists(path("p/truth_tree.vtp")));
}

}  // namespace
}  // namespace hepatica
