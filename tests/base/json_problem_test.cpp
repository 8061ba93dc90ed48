// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/json_problem.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <stdexcept>

namespace hepatica {
namespace {

TEST(JsonProblem, LeavesOutTheLibrarysNumbers) {
    try {
        nlohmann::json("text").get<double>();
        FAIL() << "a text was taken for a number";
    } catch (const nlohmann::json::exception& error) {
        EXPECT_EQ(json_problem(error), "is damaged (type must be number, but is string)");
    }
}

TEST(JsonProblem, KeepsBracketsOfOthers) {
    EXPECT_EQ(json_problem(std::runtime_error("[1, 2] is no place")),
              "is damaged ([1, 2] is no place)");
}

}  // namespace
}  // namespace hepatica
