// SPDX-License-Identifier: GPL-3.0-or-later
// The cache gives back what was kept, to the very program that kept it, or nothing.
#include "core/opening/built_in_cache.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <thread>

#include "core/base/error.h"
#include "core/opening/open_patient.h"
#include "tests/patient/parted_patient.h"

namespace hepatica {
namespace {

namespace fs = std::filesystem;

class BuiltInCacheTest : public ::testing::Test {
  protected:
    BuiltInCacheTest() { keep(cache_, kept_); }
    ~BuiltInCacheTest() override { fs::remove_all(cache_.folder); }

    void expect_whole(const std::optional<PatientCase>& found) {
        ASSERT_TRUE(found.has_value());
        EXPECT_EQ(hash_of(*found), hash_of(kept_));
        EXPECT_EQ(found->mask.voxels, kept_.mask.voxels);
        EXPECT_EQ(found->corrections.bridges.size(), kept_.corrections.bridges.size());
        EXPECT_EQ(found->source.parameters_json, kept_.source.parameters_json);
    }
    std::vector<fs::path> files() {
        std::vector<fs::path> found;
        for (const auto& entry : fs::recursive_directory_iterator(cache_.folder))
            if (entry.is_regular_file()) found.push_back(entry.path());
        return found;
    }
    static std::string read(const fs::path& file) {
        std::ifstream in(file, std::ios::binary);
        return {std::istreambuf_iterator<char>(in), {}};
    }
    static void write(const fs::path& file, const std::string& text) {
        std::ofstream(file, std::ios::binary) << text;
    }

    const BuiltInCache cache_{fs::path(std::getenv("TEST_TMPDIR")) / "users" / "cache",
                              "0.1.0 abc"};
    const PatientCase kept_ = test::patient_with_bridges();
};

TEST_F(BuiltInCacheTest, gives_back_what_was_kept) {
    EXPECT_TRUE(holds_patient(cache_));
    expect_whole(patient_of(cache_));
    keep(cache_, kept_);  // once more, over it
    expect_whole(patient_of(cache_));
}

TEST_F(BuiltInCacheTest, has_nothing_for_another_program_and_keeps_one_patient_only) {
    const BuiltInCache other{cache_.folder, "0.1.0 abd"};
    EXPECT_FALSE(holds_patient(other));
    EXPECT_FALSE(patient_of(other).has_value());
    const std::size_t files_before = files().size();
    keep(other, kept_);
    expect_whole(patient_of(other));
    EXPECT_FALSE(patient_of(cache_).has_value());
    EXPECT_EQ(files().size(), files_before);
}

TEST_F(BuiltInCacheTest, whatever_is_damaged_counts_as_absent) {
    ASSERT_GE(files().size(), 6u);
    for (const fs::path& file : files()) {
        SCOPED_TRACE(file);
        const std::string whole = read(file);
        std::string flipped = whole;
        flipped[flipped.size() / 2] = static_cast<char>(flipped[flipped.size() / 2] ^ 4);
        for (const std::string& damaged :
             {flipped, whole + '\n', whole.substr(0, whole.size() / 2), std::string()}) {
            write(file, damaged);
            // tree.swc is for other programs: nobody reads it here.
            if (file.extension() == ".swc") {
                expect_whole(patient_of(cache_));
            } else {
                EXPECT_FALSE(patient_of(cache_).has_value());
            }
        }
        fs::remove(file);
        EXPECT_EQ(patient_of(cache_).has_value(), file.extension() == ".swc");
        write(file, whole);
        expect_whole(patient_of(cache_));
    }
}

// Reading a process's memory from address 0 on fails.
TEST_F(BuiltInCacheTest, what_fails_to_be_read_counts_as_absent) {
    if (!fs::exists("/proc/self/mem")) GTEST_SKIP() << "no file whose reading fails";
    const fs::path label = cache_.folder / "built_in_patient" / "label.txt";
    ASSERT_TRUE(fs::remove(label));
    fs::create_symlink("/proc/self/mem", label);
    EXPECT_FALSE(holds_patient(cache_));
    EXPECT_FALSE(patient_of(cache_).has_value());
}

TEST_F(BuiltInCacheTest, something_foreign_in_its_place_is_no_error) {
    fs::remove_all(cache_.folder / "built_in_patient");
    write(cache_.folder / "built_in_patient", "a file");
    EXPECT_FALSE(patient_of(cache_).has_value());
    keep(cache_, kept_);  // whether it can or not
    fs::remove_all(cache_.folder);
    write(cache_.folder, "a file where the cache should be");
    EXPECT_FALSE(patient_of(cache_).has_value());
    keep(cache_, kept_);
    EXPECT_FALSE(patient_of(cache_).has_value());
    EXPECT_EQ(read(cache_.folder), "a file where the cache should be");
}

TEST_F(BuiltInCacheTest, no_folder_means_no_cache) {
    const BuiltInCache none{{}, "0.1.0 abc"};
    keep(none, kept_);
    EXPECT_FALSE(holds_patient(none));
    EXPECT_FALSE(patient_of(none).has_value());
}

TEST_F(BuiltInCacheTest, programs_that_start_at_once_do_each_other_no_harm) {
    {
        std::vector<std::jthread> programs;
        for (int program = 0; program < 4; ++program)
            programs.emplace_back([&] {
                for (int i = 0; i < 5; ++i) {
                    keep(cache_, kept_);
                    if (const auto found = patient_of(cache_)) expect_whole(found);
                }
            });
    }
    expect_whole(patient_of(cache_));
    for (const auto& entry : fs::directory_iterator(cache_.folder))
        EXPECT_EQ(entry.path().filename(), "built_in_patient");  // no temporary is left
}

TEST_F(BuiltInCacheTest, opening_takes_the_patient_from_there_in_one_stage) {
    OpenRequest request{.built_in = true, .reconstruct = {}, .cache = cache_};
    Job job;
    const OpenedPatient opened = open_patient(request, job);
    EXPECT_EQ(hash_of(*opened.patient), hash_of(kept_));
    EXPECT_EQ(opened.title, "Built-in patient");
    EXPECT_TRUE(opened.warnings.empty()) << "as when it is made";
    EXPECT_TRUE(opened.folder.empty());  // a cache is no place to save to
    EXPECT_EQ(opening_stage_count(request), 1);
    EXPECT_EQ(job.stage_times().size(), 1u);
}

TEST_F(BuiltInCacheTest, what_was_measured_is_found_again_and_has_no_part_in_the_label) {
    const fs::path place = case_of(cache_);
    ASSERT_TRUE(fs::is_directory(place));
    write(place / "dial.json", "{\"a\": 1}");
    const std::optional<PatientCase> found = patient_of(cache_);
    expect_whole(found);
    EXPECT_TRUE(found->dial_json.empty()) << "who wants it looks whether it is damaged";
    BuiltInCache with_dial = cache_;
    with_dial.with_dial = true;
    const std::optional<PatientCase> measured = patient_of(with_dial);
    ASSERT_TRUE(measured);
    EXPECT_EQ(measured->dial_json, "{\"a\": 1}") << "without another copy of the patient";
    Job job;
    EXPECT_EQ(open_patient({.built_in = true, .reconstruct = {}, .cache = cache_}, job).cached_case,
              place);
    EXPECT_TRUE(case_of({cache_.folder, "0.1.0 abd"}).empty()) << "of another program";
    EXPECT_TRUE(case_of({{}, "0.1.0 abc"}).empty());
}

// It sets out to make the patient: nobody waits for that here.
TEST_F(BuiltInCacheTest, opening_makes_anew_what_is_damaged) {
    write(cache_.folder / "built_in_patient" / "patient.hep" / "case.json", "{}");
    Job job;
    job.cancel();
    EXPECT_THROW(open_patient({.built_in = true, .reconstruct = {}, .cache = cache_}, job),
                 Cancelled);
}

}  // namespace
}  // namespace hepatica
