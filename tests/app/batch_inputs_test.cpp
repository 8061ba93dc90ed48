// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/batch/batch_inputs.h"

#include <gtest/gtest.h>

#include <fstream>
#include <map>

#include "core/base/error.h"

namespace hepatica {
namespace {

namespace fs = std::filesystem;

class BatchInputs : public testing::Test {
  protected:
    void SetUp() override {
        fs::remove_all(folder_);
        fs::create_directories(folder_ / "scans" / "dora");
        fs::create_directories(folder_ / "masks");
        for (const char* name : {"scans/carl.nii.gz", "scans/bea.mha", "scans/bea.nrrd",
                                 "scans/notes.txt", "scans/.hidden.nii", "masks/dora.nii.gz"})
            std::ofstream(folder_ / name) << "x";
    }
    void TearDown() override { fs::remove_all(folder_); }

    fs::path folder_ = fs::path(testing::TempDir()) / "hepatica batch inputs";
};

TEST_F(BatchInputs, AreFoldersAndVolumesInTheOrderOfTheirNames) {
    const auto inputs = batch_inputs(folder_ / "scans", folder_ / "masks");
    std::vector<std::string> names;
    for (const BatchInput& input : inputs) names.push_back(input.patient);
    EXPECT_EQ(names, (std::vector<std::string>{"bea.mha", "bea.nrrd", "carl", "dora"}));
    EXPECT_EQ(inputs[2].ct, folder_ / "scans" / "carl.nii.gz");
    EXPECT_FALSE(inputs[2].liver_mask.has_value());
    EXPECT_EQ(inputs[3].liver_mask, folder_ / "masks" / "dora.nii.gz");
    EXPECT_FALSE(batch_inputs(folder_ / "scans", {})[3].liver_mask.has_value());
}

// With --keep-names the case of one would take the place of another's.
TEST_F(BatchInputs, HaveNamesThatDiffer) {
    const auto names_of = [&](const std::vector<std::string>& files, const std::string& made) {
        fs::remove_all(folder_ / "named");
        fs::create_directories(folder_ / "named" / made);
        for (const std::string& file : files) std::ofstream(folder_ / "named" / file) << "x";
        std::vector<std::string> names;
        for (const BatchInput& input : batch_inputs(folder_ / "named", {})) {
            names.push_back(input.patient);
            EXPECT_EQ(input.scan, input.patient);
        }
        return names;
    };
    EXPECT_EQ(names_of({"a.nii", "a.mha", "a.nii.mha"}, "b"),
              (std::vector<std::string>{"a.mha", "a.nii", "a.nii.mha", "b"}));
    EXPECT_EQ(names_of({"a.nii.gz", "a.nii.mha"}, "a.nii"),
              (std::vector<std::string>{"a.nii", "a", "a.nii.mha"}));
    EXPECT_EQ(names_of({"a.nii", "a.nii.mha"}, "b"), (std::vector<std::string>{"a", "a.nii", "b"}));
}

TEST_F(BatchInputs, RefusesAFolderWithoutCtOrOneThatIsNotThere) {
    fs::create_directories(folder_ / "empty");
    EXPECT_THROW(batch_inputs(folder_ / "empty", {}), InputError);
    EXPECT_THROW(batch_inputs(folder_ / "nowhere", {}), InputError);
    EXPECT_THROW(batch_inputs(folder_ / "scans", folder_ / "nowhere"), InputError);
}

TEST_F(BatchInputs, HavePseudonymsThatStayTheirOwn) {
    auto inputs = batch_inputs(folder_ / "scans", {});
    use_pseudonyms(inputs);
    std::map<std::string, std::string> by_scan;
    for (const BatchInput& input : inputs) by_scan[input.scan] = input.patient;
    EXPECT_EQ(by_scan.size(), 4u);
    // printf carl | sha256sum
    EXPECT_EQ(by_scan.at("carl"), "P-69bfe1e6");
    inputs.erase(inputs.begin());  // what is added or taken away renames nobody else
    use_pseudonyms(inputs);
    for (const BatchInput& input : inputs) EXPECT_EQ(input.patient, by_scan.at(input.scan));
    std::vector<BatchInput> twins(2, inputs.front());
    use_pseudonyms(twins);
    EXPECT_NE(twins[0].patient, twins[1].patient);
}

TEST(BatchShares, TogetherAreTheWholeWithoutOverlap) {
    std::vector<BatchInput> inputs;
    for (int i = 0; i < 11; ++i) inputs.push_back({std::to_string(i), {}, {}, {}});
    for (const int count : {1, 3, 11, 20}) {
        std::map<std::string, int> times;
        std::size_t largest = 0, smallest = 11;
        for (int number = 1; number <= count; ++number) {
            const auto share = share_of(inputs, number, count);
            largest = std::max(largest, share.size());
            smallest = std::min(smallest, share.size());
            for (const BatchInput& input : share) ++times[input.patient];
        }
        EXPECT_EQ(times.size(), inputs.size()) << count;
        for (const auto& [name, n] : times) EXPECT_EQ(n, 1) << name;
        EXPECT_LE(largest - smallest, 1u) << count;
    }
}

}  // namespace
}  // namespace hepatica
