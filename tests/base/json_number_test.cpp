// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/json_number.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <string>

namespace hepatica {
namespace {

using Json = nlohmann::json;

TEST(WholeNumber, ComesFromEverySpellingOfIt) {
    EXPECT_EQ(whole_number<int>(Json::parse("3")), 3);
    EXPECT_EQ(whole_number<int>(Json::parse("-3")), -3);
    EXPECT_EQ(whole_number<int>(Json::parse("3.0")), 3);
    EXPECT_EQ(whole_number<int>(Json::parse("-1e3")), -1000);
    EXPECT_EQ(whole_number<std::uint8_t>(Json::parse("255")), 255);
    EXPECT_EQ(whole_number<int>(nlohmann::ordered_json::parse("7")), 7);
    EXPECT_EQ(whole_numbers<int>(Json::parse("[1, 2.0, -3]")), (std::vector{1, 2, -3}));
}

TEST(WholeNumber, ReachesToTheLimitsOfItsType) {
    using Limits = std::numeric_limits<int>;
    EXPECT_EQ(whole_number<int>(Json(Limits::max())), Limits::max());
    EXPECT_EQ(whole_number<int>(Json(Limits::min())), Limits::min());
    constexpr auto largest = std::numeric_limits<std::uint64_t>::max();
    EXPECT_EQ(whole_number<std::uint64_t>(Json(largest)), largest);
}

TEST(WholeNumber, RefusesWhatIsNoneOrDoesNotFit) {
    for (const char* text : {"1e300", "-1e300", "2147483648", "-2147483649", "2147483648.0",
                             "18446744073709551615", "0.5", "\"3\"", "true", "null", "[3]"})
        EXPECT_THROW(whole_number<int>(Json::parse(text)), Json::exception) << text;
    EXPECT_THROW(whole_number<std::uint8_t>(Json(256)), Json::exception);
    EXPECT_THROW(whole_number<std::uint8_t>(Json(-1)), Json::exception);
    EXPECT_THROW(whole_number<std::uint64_t>(Json(-1)), Json::exception);
    EXPECT_THROW(whole_numbers<int>(Json::parse("[1, 2.5]")), Json::exception);
    try {
        whole_number<int>(Json::parse("1e300"));
        FAIL();
    } catch (const Json::exception& error) {
        EXPECT_NE(std::string(error.what()).find("1e+300"), std::string::npos) << error.what();
    }
}

}  // namespace
}  // namespace hepatica
