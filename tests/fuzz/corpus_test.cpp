// SPDX-License-Identifier: GPL-3.0-or-later
// What the fuzzers began with and what they found, through the same entry points, without a fuzzer:
// every input is read or refused in words.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

#include "tests/fuzz/readers.h"

namespace hepatica::fuzz {
namespace {

namespace fs = std::filesystem;

const fs::path corpus = fs::path(HEPATICA_SOURCE_DIR) / "tests/fuzz/corpus";

std::vector<Reader> all_readers() {
    std::vector<Reader> all;
    for (const auto& list : {image_readers(), tree_readers(), json_readers()})
        all.insert(all.end(), list.begin(), list.end());
    return all;
}

std::vector<fs::path> inputs_of(std::string_view name) {
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(corpus / name)) files.push_back(entry.path());
    std::ranges::sort(files);
    return files;
}

class Corpus : public testing::TestWithParam<Reader> {};

TEST_P(Corpus, IsReadOrRefused) {
    const std::vector<fs::path> inputs = inputs_of(GetParam().name);
    ASSERT_FALSE(inputs.empty());
    for (const fs::path& input : inputs) {
        std::ifstream in(input, std::ios::binary);
        const std::vector<char> bytes{std::istreambuf_iterator<char>(in), {}};
        const auto* first = reinterpret_cast<const std::uint8_t*>(bytes.data());
        EXPECT_NO_THROW(GetParam().read({first, bytes.size()})) << input;
        EXPECT_NO_THROW(GetParam().read({first, bytes.size() / 2})) << input << ", cut in half";
    }
}

INSTANTIATE_TEST_SUITE_P(Readers, Corpus, testing::ValuesIn(all_readers()),
                         [](const auto& reader) { return std::string(reader.param.name); });

// A folder without a reader would never be run.
TEST(CorpusFolders, AllHaveTheirReader) {
    const std::vector<Reader> readers = all_readers();
    for (const auto& entry : fs::directory_iterator(corpus)) {
        const std::string name = entry.path().filename().string();
        EXPECT_EQ(std::ranges::count(readers, name, &Reader::name), 1) << name;
    }
}

}  // namespace
}  // namespace hepatica::fuzz
