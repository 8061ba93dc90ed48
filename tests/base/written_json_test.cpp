// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/written_json.h"

#include <gtest/gtest.h>

#include "core/base/json_problem.h"

namespace hepatica {
namespace {

using OrderedJson = nlohmann::ordered_json;

std::string doubled_in(const std::string& text) {
    try {
        parse_written<OrderedJson>(text);
    } catch (const InputError& error) {
        return error.place();
    }
    return "none";
}

TEST(WrittenJson, HasNoKeyOfAnObjectTwice) {
    EXPECT_EQ(doubled_in(R"({"actions": [1], "name": "s", "actions": []})"), "actions");
    EXPECT_EQ(doubled_in(R"([{"a": {"at_s": 0, "b": {}, "at_s": 5}}])"), "at_s");
    EXPECT_EQ(doubled_in(R"({"a": {"a": 1, "b": {"a": 2}}, "b": [{"a": 3}, {"a": 4}]})"), "none");
    EXPECT_EQ(doubled_in("[]"), "none");
}

TEST(WrittenJson, IsWhatTheLibraryReads) {
    const std::string text = R"({"b": [1, 2.5, {"c": null}], "a": {"d": "x", "e": true}})";
    EXPECT_EQ(parse_written<OrderedJson>(text).dump(), OrderedJson::parse(text).dump());
    EXPECT_THROW(parse_written<OrderedJson>("{"), OrderedJson::exception);
}

std::string fault_of(const std::string& text) {
    try {
        parse_written<OrderedJson>(text);
    } catch (const OrderedJson::exception& error) {
        return json_problem(error);
    }
    return "none";
}

// The library names the place of other faults alone.
TEST(WrittenJson, NamesLineAndColumnOfANumberThatIsTooLarge) {
    const std::string at = "is damaged (parse error at line ", what = ": number overflow parsing '";
    EXPECT_EQ(fault_of("[1e400]"), at + "1, column 6" + what + "1e400')");
    EXPECT_EQ(fault_of("{\"a\": \"1e400\",\n\n \"b\": -1e999\n}"),
              at + "3, column 12" + what + "-1e999')");
    EXPECT_EQ(fault_of("1e400"), at + "1, column 5" + what + "1e400')");
    EXPECT_EQ(fault_of("[1e300, 2e-400]"), "none");
    EXPECT_NE(fault_of("[1,\n2e]").find("line 2, column 3"), std::string::npos);
}

}  // namespace
}  // namespace hepatica
