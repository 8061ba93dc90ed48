// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/three_digits.h"

#include <gtest/gtest.h>

#include <limits>

namespace hepatica {
namespace {

TEST(ThreeDigits, AreAllThatAValueHasBeforeItsDecimalSign) {
    EXPECT_EQ(in_three_digits(1151.3), 1150.0);
    EXPECT_EQ(in_three_digits(1155.0), 1160.0);
    EXPECT_EQ(in_three_digits(-12345.0), -12300.0);
    EXPECT_EQ(in_three_digits(9996.0), 10000.0);
    EXPECT_EQ(in_three_digits(999.6), 1000.0);
}

TEST(ThreeDigits, LeaveSmallerValuesAsTheyAre) {
    for (const double value : {0.0, 0.0123, -12.3456, 467.26, 999.4})
        EXPECT_EQ(in_three_digits(value), value);
    EXPECT_EQ(in_three_digits(std::numeric_limits<double>::infinity()),
              std::numeric_limits<double>::infinity());
    EXPECT_TRUE(std::isnan(in_three_digits(std::nan(""))));
}

}  // namespace
}  // namespace hepatica
