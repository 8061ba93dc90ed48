// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/written_json.h"

#include <gtest/gtest.h>

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
    EXPECT_THROW(parse_written<OrderedJson>("[1e400]"), OrderedJson::exception);
}

}  // namespace
}  // namespace hepatica
