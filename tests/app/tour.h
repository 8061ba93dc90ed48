// SPDX-License-Identifier: GPL-3.0-or-later
// A small synthetic patient and its case, made by the real program once for all tests of a suite.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/app/run_program.h"

namespace hepatica::test {

using Json = nlohmann::json;

// One JSON object and nothing else on standard output.
inline Json answer(std::vector<std::string> arguments) {
    arguments.push_back("--json");
    const Outcome run = run_cli(arguments);
    EXPECT_EQ(run.exit_code, 0) << arguments[0] << ": " << run.errors;
    const Json json = Json::parse(run.output, nullptr, false);
    EXPECT_TRUE(json.is_object()) << run.output;
    return json.is_object() ? json : Json::object();
}

class Tour : public testing::Test {
  protected:
    static void SetUpTestSuite() {
        std::filesystem::remove_all(folder());
        std::filesystem::create_directories(folder());
        phantom_ = answer({"phantom", path("p"), "--seed", "2", "--dims", "128,128,96", "--spacing",
                           "1.6,1.6,1.7", "--generations", "4"});
        case_ = answer({"reconstruct", path("p/ct"), "--vessel-mask", path("p/truth_mask.nii.gz"),
                        "--out", path("p.hep"), "--tetrahedra", "3000"});
    }
    static void TearDownTestSuite() { std::filesystem::remove_all(folder()); }

    static std::filesystem::path folder() {
        return std::filesystem::path(testing::TempDir()) / "hepatica tour";
    }
    static std::string path(const std::string& name) { return (folder() / name).string(); }

    static inline Json phantom_, case_;
};

}  // namespace hepatica::test
