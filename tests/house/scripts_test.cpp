// SPDX-License-Identifier: GPL-3.0-or-later
// The scripts, as far as they can be tried without building, installing or measuring anything.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "tests/support/shell.h"

namespace hepatica {
namespace {

namespace fs = std::filesystem;
using test::shell;
using test::ShellAnswer;

const fs::path scripts = fs::path(HEPATICA_SOURCE_DIR) / "scripts";

bool says(const ShellAnswer& answer, const std::string& words) {
    return answer.output.find(words) != std::string::npos;
}

// What the program would be called with by the job of this number in an array of jobs.
ShellAnswer job(int number, int first, int last, int step, int count) {
    const std::string slurm = "SLURM_ARRAY_TASK_";
    return shell("env -i PATH=\"$PATH\" " + slurm + "ID=" + std::to_string(number) + " " + slurm +
                 "MIN=" + std::to_string(first) + " " + slurm + "MAX=" + std::to_string(last) +
                 " " + slurm + "STEP=" + std::to_string(step) + " " + slurm +
                 "COUNT=" + std::to_string(count) + " HEPATICA_CLI=echo '" +
                 (scripts / "batch_array").string() + "' scans out --refine 1");
}

TEST(BatchArray, SharesOfAnySeriesOfNumbersAreTheWhole) {
    EXPECT_TRUE(says(job(7, 1, 20, 1, 20), "--task 7 --of 20 --refine 1")) << "--array=1-20";
    EXPECT_TRUE(says(job(0, 0, 19, 1, 20), "--task 1 --of 20")) << "--array=0-19";
    for (int share = 1; share <= 5; ++share)
        EXPECT_TRUE(
            says(job(2 * share - 1, 1, 9, 2, 5), "--task " + std::to_string(share) + " --of 5"))
            << "--array=1-10:2";
}

TEST(BatchArray, RefusesAListOfNumbersThatTellsNoShare) {
    for (const int number : {3, 7}) {
        const ShellAnswer answer = job(number, 3, 7, 1, 2);
        EXPECT_EQ(answer.exit_code, 2) << answer.output;
        EXPECT_TRUE(says(answer, "--array=1-N")) << answer.output;
    }
}

// A copy of one script, with nothing around it.
class LonelyScript : public testing::Test {
  protected:
    void SetUp() override { fs::create_directories(folder_ / "scripts"); }
    void TearDown() override { fs::remove_all(folder_); }

    ShellAnswer answer(const std::string& name, const std::string& words,
                       const std::string& environment = "") const {
        fs::copy_file(scripts / name, folder_ / "scripts" / name,
                      fs::copy_options::overwrite_existing);
        return shell(environment + " '" + (folder_ / "scripts" / name).string() + "' " + words);
    }

    // Puts a program in the place of one that the script calls.
    void stand_in(const std::string& name, const std::string& commands) const {
        const fs::path file = folder_ / name;
        fs::create_directories(file.parent_path());
        std::ofstream(file) << "#!/bin/sh\n" << commands << "\n";
        fs::permissions(file, fs::perms::owner_all);
    }

    const fs::path folder_ = fs::path(testing::TempDir()) / "script alone";
};

TEST_F(LonelyScript, OfTheFuzzersSaysHowTheyAreBuilt) {
    const ShellAnswer unbuilt = answer("fuzz", "1");
    EXPECT_NE(unbuilt.exit_code, 0);
    EXPECT_TRUE(says(unbuilt, "scripts/build fuzz fuzz_trees")) << unbuilt.output;
    EXPECT_FALSE(says(unbuilt, "Traceback")) << unbuilt.output;
}

// As where a library is missing: nothing was run, and the empty table looked like success.
TEST_F(LonelyScript, OfTheFuzzersNamesOneThatDoesNotStart) {
    for (const std::string name : {"trees", "json", "images"})
        stand_in("build/fuzz/bin/fuzz_" + name, "echo 'no such library' >&2; exit 127");
    const ShellAnswer answered = answer("fuzz", "60");
    EXPECT_NE(answered.exit_code, 0);
    EXPECT_TRUE(says(answered, "fuzz_trees does not start: no such library")) << answered.output;
}

// It used no time and found nothing, so that its turn came again for ever.
TEST_F(LonelyScript, OfTheFuzzersEndsWithAReaderThatEndsByItself) {
    for (const std::string name : {"trees", "json", "images"})
        stand_in("build/fuzz/bin/fuzz_" + name,
                 "[ -z \"$READER\" ] || exit 1; echo '  " + name + "_reader' >&2");
    const ShellAnswer answered = answer("fuzz", "60 json_reader");
    EXPECT_NE(answered.exit_code, 0);
    EXPECT_TRUE(says(answered, "json_reader ended by itself (1)")) << answered.output;
    EXPECT_FALSE(says(answered, "Traceback")) << answered.output;
}

TEST_F(LonelyScript, OfTheAccuracyEndsWithAWordWhereItFails) {
    EXPECT_EQ(answer("measure_accuracy", "--help").exit_code, 0);
    const ShellAnswer unbuilt = answer("measure_accuracy", "--seeds 1-1");
    EXPECT_NE(unbuilt.exit_code, 0);
    EXPECT_TRUE(says(unbuilt, "scripts/build release hepatica-cli")) << unbuilt.output;
    const ShellAnswer failed = answer("measure_accuracy", "--seeds 1-1", "HEPATICA_CLI=false");
    EXPECT_NE(failed.exit_code, 0);
    EXPECT_TRUE(says(failed, "out/accuracy/log")) << failed.output;
}

// Of two patients; one key may be left out.
std::string comparison_without(const std::string& key) {
    std::string commands =
        "[ \"$1\" = compare ] || exit 0\ncase \"$2\" in\n*p1.hep) "
        "bias=-0.100 ;;\n*) bias=0.050 ;;\nesac\necho \"{\"\n";
    for (const std::string column : {"dice", "cldice", "centreline_mean_mm", "centreline_p95_mm",
                                     "length_found", "radius_bias_mm", "radius_mae_mm",
                                     "bifurcation_recall", "bifurcation_precision", "components"})
        if (column != key)
            commands += "echo '\"" + column + "\": '" +
                        (column == "radius_bias_mm" ? std::string("$bias") : "0.912") + "','\n";
    return commands + "echo \"}\"";
}

TEST_F(LonelyScript, OfTheAccuracyShowsTheWorstWithItsSign) {
    stand_in("cli", comparison_without(""));
    const ShellAnswer answered =
        answer("measure_accuracy", "--seeds 1-2", "HEPATICA_CLI=./cli LC_ALL=de_DE.UTF-8");
    EXPECT_EQ(answered.exit_code, 0) << answered.output;
    EXPECT_TRUE(says(answered, "| mean | 0.912 | 0.912 | 0.912 | 0.912 | 0.912 | -0.025 |"))
        << answered.output;
    EXPECT_TRUE(says(answered, "| worst | 0.912 | 0.912 | 0.912 | 0.912 | 0.912 | -0.100 |"))
        << answered.output;
}

// A value that is missing was printed as 0.000: a perfect distance.
TEST_F(LonelyScript, OfTheAccuracyNamesAValueThatIsMissing) {
    for (const std::string column : {"dice", "centreline_mean_mm"}) {
        stand_in("cli", comparison_without(column));
        const ShellAnswer answered =
            answer("measure_accuracy", "--seeds 1-1", "HEPATICA_CLI=./cli");
        EXPECT_NE(answered.exit_code, 0);
        EXPECT_TRUE(says(answered, "compare says nothing of " + column)) << answered.output;
    }
}

// GoogleTest names a skipped test twice; the names of some have a capital D.
TEST_F(LonelyScript, OfTheDeviceCountsEachSkippedTestOnce) {
    stand_in("bin/nvidia-smi", "echo 9.0");
    stand_in("bin/nproc", "echo 1");
    stand_in("bin/cmake", "");
    stand_in("bin/compute-sanitizer", "");
    stand_in("build/solver-only/bin/gpu_bench", "echo '{}' >\"$1\"");
    stand_in("build/solver-only/bin/gpu_tests", R"(cat <<'LOG'
[ RUN      ] Gpu/TwoBackEnds.OneStepAgrees/device_corotated
[  SKIPPED ] Gpu/TwoBackEnds.OneStepAgrees/device_corotated (0 ms)
[ RUN      ] DeviceSkeleton.CorrectsOnADeviceAsWell
[  SKIPPED ] DeviceSkeleton.CorrectsOnADeviceAsWell (0 ms)
[ RUN      ] OfNodes/Products.AreThoseOfADenseMatrixOnADevice/0
[  SKIPPED ] OfNodes/Products.AreThoseOfADenseMatrixOnADevice/0, where GetParam() = 3 (12 ms)
[  SKIPPED ] 3 tests, listed below:
[  SKIPPED ] Gpu/TwoBackEnds.OneStepAgrees/device_corotated
[  SKIPPED ] DeviceSkeleton.CorrectsOnADeviceAsWell
[  SKIPPED ] OfNodes/Products.AreThoseOfADenseMatrixOnADevice/0, where GetParam() = 3
LOG
)");
    const ShellAnswer answered =
        answer("gpu_check", "", "PATH='" + (folder_ / "bin").string() + "':\"$PATH\"");
    EXPECT_NE(answered.exit_code, 0) << "tests were skipped";
    std::ifstream result(folder_ / "build" / "gpu_check" / "gpu_check.json");
    const std::string json{std::istreambuf_iterator<char>(result), {}};
    EXPECT_NE(json.find("\"device_tests_skipped\": 3,"), std::string::npos)
        << json << answered.output;
}

TEST_F(LonelyScript, OfThePackagesSaysWhichSystemItIsFor) {
    std::ofstream(folder_ / "scripts" / "packages.txt") << "a-package # of Debian\n";
    const fs::path bin = folder_ / "bin";  // of a system without apt
    fs::create_directories(bin);
    for (const std::string tool : {"bash", "dirname", "sed"})
        fs::create_symlink("/usr/bin/" + tool, bin / tool);
    const ShellAnswer elsewhere = answer("install_packages", "", "PATH='" + bin.string() + "'");
    EXPECT_EQ(elsewhere.exit_code, 1) << elsewhere.output;
    EXPECT_TRUE(says(elsewhere, "Debian 12")) << elsewhere.output;
    EXPECT_TRUE(says(elsewhere, "a-package")) << elsewhere.output;
}

}  // namespace
}  // namespace hepatica
