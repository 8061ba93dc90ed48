// SPDX-License-Identifier: GPL-3.0-or-later
// Many CTs in one call of the real program: what fails, what is gone on with, what is left behind.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "core/patient/patient_case.h"
#include "tests/app/tour.h"

namespace hepatica {
namespace {

namespace fs = std::filesystem;
using test::answer;
using test::Json;
using test::Outcome;
using test::run_cli;

class Batch : public testing::Test {
  protected:
    // Two good patients about one that is no image.
    static void SetUpTestSuite() {
        fs::remove_all(root());
        fs::create_directories(root() / "scans");
        fs::create_directories(root() / "livers");
        answer({"phantom", path("p"), "--dims", "88,88,64", "--spacing", "2,2,2", "--generations",
                "3", "--format", "nifti"});
        for (const char* name : {"anton", "carla"}) {
            fs::copy_file(root() / "p/ct.nii.gz",
                          root() / "scans" / (name + std::string(".nii.gz")));
            fs::copy_file(root() / "p/liver.nii.gz",
                          root() / "livers" / (name + std::string(".nii.gz")));
        }
        std::ofstream(root() / "scans/berta.nii.gz") << "no image";
    }
    static void TearDownTestSuite() { fs::remove_all(root()); }
    void SetUp() override { fs::remove_all(root() / "out"); }

    static fs::path root() { return fs::path(testing::TempDir()) / "hepatica batch"; }
    static std::string path(const std::string& name) { return (root() / name).string(); }
    // On a grid that is no finer than it must be: what is found does not matter here.
    static std::vector<std::string> with_small_cases(std::vector<std::string> arguments) {
        arguments.insert(arguments.end(), {"--tetrahedra", "1500", "--spacing-mm", "1.5"});
        return arguments;
    }
    // Patients are called as their scans are.
    static std::vector<std::string> call(std::vector<std::string> more = {}) {
        more.push_back("--keep-names");
        return call_with_pseudonyms(more);
    }
    static std::vector<std::string> call_with_pseudonyms(std::vector<std::string> more = {}) {
        std::vector<std::string> arguments =
            with_small_cases({"reconstruct", "--batch", path("scans"), "--out", path("out"),
                              "--liver-mask", path("livers")});
        arguments.insert(arguments.end(), more.begin(), more.end());
        return arguments;
    }
    static std::string text_of(const fs::path& file) {
        std::ifstream in(file);
        return {std::istreambuf_iterator<char>(in), {}};
    }
    // State of each patient in summary.csv.
    static std::map<std::string, std::string> states() {
        std::ifstream in(root() / "out/summary.csv");
        std::map<std::string, std::string> found;
        std::string line;
        std::getline(in, line);
        EXPECT_EQ(line, "patient,state,seconds,vessels_mm,liver_ml,doubts,reason");
        while (std::getline(in, line)) {
            const std::size_t comma = line.find(',');
            const std::size_t second = line.find(',', comma + 1);
            found[line.substr(1, comma - 2)] = line.substr(comma + 1, second - comma - 1);
        }
        return found;
    }
    using States = std::map<std::string, std::string>;
};

TEST_F(Batch, OneThatFailsDoesNotStopTheRestAndNothingIsMadeTwice) {
    const Json first = answer(call());
    EXPECT_EQ(first.at("patients"), 3);
    EXPECT_EQ(first.at("done"), 2);
    EXPECT_EQ(first.at("failed"), 1);
    EXPECT_EQ(first.at("made_now"), 3);
    EXPECT_EQ(states(), (States{{"anton", "done"}, {"berta", "failed"}, {"carla", "done"}}));
    const PatientCase carla = read_case(root() / "out/cases/carla.hep");
    EXPECT_FALSE(carla.tree.segments.empty());
    EXPECT_FALSE(fs::exists(root() / "out/cases/berta.hep"));
    const std::string page = text_of(root() / "out/index.html");
    EXPECT_NE(page.find("pictures/carla.png"), std::string::npos);
    EXPECT_NE(page.find("berta.nii.gz"), std::string::npos);  // with the reason
    EXPECT_NE(page.find("2 done, 1 failed, 0 to do"), std::string::npos);
    EXPECT_TRUE(fs::exists(root() / "out/pictures/anton.png"));

    const auto written = fs::last_write_time(root() / "out/cases/carla.hep/case.json");
    EXPECT_EQ(answer(call()).at("made_now"), 0);
    EXPECT_EQ(answer(call({"--retry"})).at("made_now"), 1);
    EXPECT_EQ(fs::last_write_time(root() / "out/cases/carla.hep/case.json"), written);

    const Outcome other = run_cli(call({"--method", "vesselness"}));
    EXPECT_EQ(other.exit_code, 1);
    EXPECT_NE(other.errors.find("other options"), std::string::npos) << other.errors;
}

// A patient whose record is missing was half done: he is made anew, and the case is whole.
TEST_F(Batch, GoesOnWhereItWasInterrupted) {
    const Outcome run = run_cli(call(), {.interrupt_at = "[3/3] carla"});
    EXPECT_EQ(run.exit_code, 130) << run.errors;
    EXPECT_EQ(states(), (States{{"anton", "done"}, {"berta", "failed"}, {"carla", "to do"}}));
    EXPECT_FALSE(fs::exists(root() / "out/cases/carla.hep"));
    const Json rest = answer(call());
    EXPECT_EQ(rest.at("made_now"), 1);
    EXPECT_EQ(rest.at("done"), 2);
    EXPECT_EQ(hash_of(read_case(root() / "out/cases/carla.hep")),
              hash_of(read_case(root() / "out/cases/anton.hep")));  // the same CT
    for (const auto& entry : fs::directory_iterator(root() / "out/cases"))
        EXPECT_EQ(entry.path().extension(), ".hep") << entry.path();
}

TEST_F(Batch, SaysWhatAScanWasCalledInOneFileAlone) {
    // Its failure names another file: that of its data, which is missing.
    const fs::path header = root() / "scans/dora.mhd";
    std::ofstream(header) << "ObjectType = Image\nNDims = 3\nDimSize = 9 9 9\n"
                             "ElementType = MET_SHORT\nElementDataFile = dora.raw\n";
    const Json made = answer(call_with_pseudonyms());
    fs::remove(header);
    EXPECT_EQ(made.at("done"), 2);
    EXPECT_EQ(made.at("failed"), 2);
    const std::string names = text_of(root() / "out/names.csv");
    EXPECT_EQ(names.find("patient,scan\n\"P-"), 0u) << names;
    EXPECT_EQ(fs::status(root() / "out/names.csv").permissions(),
              fs::perms::owner_read | fs::perms::owner_write);
    int searched = 0;
    for (const auto& entry : fs::recursive_directory_iterator(root() / "out")) {
        const std::string text = entry.is_regular_file() ? text_of(entry.path()) : "";
        for (const char* scan : {"anton", "berta", "carla", "dora"}) {
            if (entry.path().filename() == "names.csv") {
                EXPECT_NE(text.find(scan), std::string::npos);
                continue;
            }
            EXPECT_EQ(text.find(scan), std::string::npos) << entry.path();
            EXPECT_EQ(fs::relative(entry.path(), root()).string().find(scan), std::string::npos);
        }
        ++searched;
    }
    EXPECT_GT(searched, 20);
    for (const auto& [patient, state] : states())
        EXPECT_EQ(fs::exists(root() / "out/cases" / (patient + ".hep")), state == "done");
    EXPECT_EQ(states().size(), 4u);
    // One scan fewer: his name is not forgotten, for his record stays.
    EXPECT_EQ(answer(call_with_pseudonyms()).at("made_now"), 0);
    EXPECT_EQ(text_of(root() / "out/names.csv"), names);
}

TEST_F(Batch, OfAVersionWithoutPseudonymsGoesOn) {
    EXPECT_EQ(answer(call({"--task", "2", "--of", "3"})).at("made_now"), 1);
    Json begun = Json::parse(text_of(root() / "out/batch.json"));
    begun.erase("keep_names");
    std::ofstream(root() / "out/batch.json") << begun.dump(2);
    EXPECT_EQ(run_cli(call_with_pseudonyms({"--task", "2", "--of", "3"})).exit_code, 1);
    EXPECT_EQ(answer(call({"--task", "2", "--of", "3"})).at("made_now"), 0);
}

TEST_F(Batch, SaysWhichOfItsOwnFilesCannotBeRead) {
    EXPECT_EQ(answer(call({"--task", "1", "--of", "3"})).at("made_now"), 1);
    for (const char* name : {"out/records/anton.json", "out/batch.json"}) {
        ASSERT_TRUE(fs::remove(root() / name)) << name;
        fs::create_directories(root() / name);
        const Outcome outcome = run_cli(call({"--task", "1", "--of", "3"}));
        EXPECT_EQ(outcome.exit_code, 1) << outcome.errors;
        EXPECT_NE(outcome.errors.find(name), std::string::npos) << outcome.errors;
        EXPECT_NE(outcome.errors.find("is a folder"), std::string::npos) << outcome.errors;
    }
}

// One table must not mix what was begun otherwise.
TEST_F(Batch, GoesOnOnlyAsItWasBegun) {
    EXPECT_EQ(answer(call({"--task", "2", "--of", "3"})).at("made_now"), 1);
    const Outcome renamed = run_cli(call_with_pseudonyms());
    EXPECT_EQ(renamed.exit_code, 1);
    EXPECT_NE(renamed.errors.find("other options"), std::string::npos) << renamed.errors;
    const Outcome without_livers = run_cli(with_small_cases(
        {"reconstruct", "--batch", path("scans"), "--out", path("out"), "--keep-names"}));
    EXPECT_EQ(without_livers.exit_code, 1);
    EXPECT_NE(without_livers.errors.find("other options"), std::string::npos)
        << without_livers.errors;
}

// A mark that says nothing would let every later call pass, with whatever options.
TEST_F(Batch, GoesOnOnlyWhereItsMarkSaysHowItWasBegun) {
    const std::vector<std::string> more{"--task", "2", "--of", "3"};
    EXPECT_EQ(answer(call(more)).at("made_now"), 1);
    const std::string mark = text_of(root() / "out/batch.json");
    for (const char* damaged : {"{", "", "null", "[]"}) {
        std::ofstream(root() / "out/batch.json") << damaged;
        const Outcome run = run_cli(call({"--method", "vesselness"}));
        EXPECT_EQ(run.exit_code, 1) << damaged << run.errors;
        EXPECT_NE(run.errors.find("batch.json: is damaged"), std::string::npos) << run.errors;
        EXPECT_EQ(text_of(root() / "out/batch.json"), damaged);
    }
    std::ofstream(root() / "out/batch.json") << mark;
    EXPECT_EQ(answer(call(more)).at("made_now"), 0);
}

// Its record holds the name as JSON can; its picture is called as the scan is.
TEST_F(Batch, ThePictureOfANameThatIsNoTextIsFound) {
    const fs::path scan = root() / "scans/dora\xff.nii.gz";
    std::ofstream(scan) << "no image";
    const std::vector<std::string> more{"--task", "2", "--of", "4"};
    answer(call(more));
    std::ofstream(root() / "out/records/dora\xff.json")
        << R"({"patient": "dora?", "state": "done", "seconds": 1, "reason": "", "vessels_mm": 1,
               "liver_ml": 1, "doubts": [], "picture": true})";
    answer(call(more));
    fs::remove(scan);
    const std::string page = text_of(root() / "out/index.html");
    EXPECT_NE(page.find("pictures/dora%FF.png"), std::string::npos) << page;
}

TEST_F(Batch, SharesOfAnArrayOfJobsMakeTheWhole) {
    EXPECT_EQ(answer(call({"--task", "1", "--of", "2"})).at("made_now"), 2);
    EXPECT_EQ(states(), (States{{"anton", "done"}, {"berta", "to do"}, {"carla", "done"}}));
    EXPECT_EQ(answer(call({"--task", "2", "--of", "2"})).at("made_now"), 1);
    EXPECT_EQ(states(), (States{{"anton", "done"}, {"berta", "failed"}, {"carla", "done"}}));
}

TEST_F(Batch, AFolderWithTheMaskOfNoScanIsRefused) {
    fs::create_directories(root() / "others");
    fs::copy_file(root() / "p/liver.nii.gz", root() / "others/emil.nii.gz");
    const Outcome run = run_cli(with_small_cases({"reconstruct", "--batch", path("scans"), "--out",
                                                  path("out"), "--liver-mask", path("others")}));
    EXPECT_EQ(run.exit_code, 1) << run.errors;
    EXPECT_NE(run.errors.find(path("others") + ": holds no liver mask"), std::string::npos)
        << run.errors;
    EXPECT_FALSE(fs::exists(root() / "out"));
}

// A row without a mask must not look like the rows with one; a liver has its volume, although
// nothing tells its segments; and the page finds the picture of a patient of any name.
TEST_F(Batch, TheTableSaysWhoseLiverHadNoMask) {
    for (const char* folder : {"few", "one"}) fs::create_directories(root() / folder);
    fs::copy_file(root() / "p/liver.nii.gz", root() / "one/anton.nii.gz");
    for (const char* scan : {"few/anton.nii.gz", "few/carla #2.nii.gz"})
        fs::copy_file(root() / "p/ct.nii.gz", root() / scan);
    answer(with_small_cases({"reconstruct", "--batch", path("few"), "--out", path("out"),
                             "--keep-names", "--liver-mask", path("one")}));
    std::istringstream table(text_of(root() / "out/summary.csv"));
    std::map<std::string, std::string> row;
    for (std::string line; std::getline(table, line);) row[line.substr(0, line.find(','))] = line;
    const std::string anton = row["\"anton\""], carla = row["\"carla #2\""];
    EXPECT_EQ(anton.find("No mask"), std::string::npos) << anton;
    EXPECT_NE(carla.find("No mask"), std::string::npos) << carla;
    for (const std::string& line : {anton, carla}) {
        std::istringstream cells(line);
        std::string cell;
        for (int i = 0; i < 5; ++i) std::getline(cells, cell, ',');
        EXPECT_GT(std::atof(cell.c_str()), 100.0) << line;
    }
    const std::string page = text_of(root() / "out/index.html");
    EXPECT_NE(page.find("src=\"pictures/carla%20%232.png\""), std::string::npos) << page;
    EXPECT_TRUE(fs::exists(root() / "out/pictures/carla #2.png"));
}

TEST_F(Batch, RefusesWhatMakesNoSense) {
    fs::create_directories(root() / "mine");
    std::ofstream(root() / "mine/thesis.txt") << "x";
    EXPECT_EQ(run_cli({"reconstruct", "--batch", path("scans"), "--out", path("mine")}).exit_code,
              1);
    EXPECT_EQ(run_cli(call({"--task", "3", "--of", "2"})).exit_code, 2);
    EXPECT_EQ(run_cli(call({"--seed-mm", "1,2,3"})).exit_code, 2);
    EXPECT_EQ(run_cli({"reconstruct", "--out", path("out")}).exit_code, 2);
    EXPECT_FALSE(fs::exists(root() / "out"));
}

// The next call would take it for a scan.
TEST_F(Batch, DoesNotWriteAmongTheScans) {
    for (const std::string out : {"scans", "scans/out", "livers/../scans/a/out"}) {
        const Outcome run = run_cli(with_small_cases(
            {"reconstruct", "--batch", path("scans/"), "--out", path(out), "--keep-names"}));
        EXPECT_EQ(run.exit_code, 2) << out << ": " << run.errors;
        EXPECT_NE(run.errors.find("lies among the scans"), std::string::npos) << run.errors;
        EXPECT_EQ(run.errors.find("[1/"), std::string::npos) << run.errors;
    }
    for (const char* made : {"scans/out", "scans/a", "scans/batch.json"})
        EXPECT_FALSE(fs::exists(root() / made)) << made;
}

}  // namespace
}  // namespace hepatica
