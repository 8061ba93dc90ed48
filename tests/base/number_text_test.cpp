// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/number_text.h"

#include <gtest/gtest.h>

#include <limits>

namespace hepatica {
namespace {

TEST(NumberText, HasSixDigits) {
    EXPECT_EQ(number_text(2.0 / 3.0), "0.666667");
    EXPECT_EQ(number_text(1e21), "1e+21");
}

TEST(FixedText, IsRoundedToTheNearest) {
    EXPECT_EQ(fixed_text(1.96, 1), "2.0");
    EXPECT_EQ(fixed_text(1.94, 1), "1.9");
    EXPECT_EQ(fixed_text(-17.5001, 0), "-18");
    EXPECT_EQ(fixed_text(2.5, 3), "2.500");
}

TEST(FixedText, KnowsNoNegativeZero) {
    EXPECT_EQ(fixed_text(-0.3, 0), "0");
    EXPECT_EQ(fixed_text(-0.04, 1), "0.0");
    EXPECT_EQ(fixed_text(-0.06, 1), "-0.1");
    EXPECT_EQ(fixed_text(0.0, 2), "0.00");
}

TEST(FixedText, HoldsTheLargestNumber) {
    EXPECT_EQ(fixed_text(-std::numeric_limits<double>::max(), 15).size(), 1u + 309u + 16u);
}

}  // namespace
}  // namespace hepatica
