// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tear/entropy.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace hepatica {
namespace {

TEST(Entropy, OfEqualSharesIsTheLogarithmOfTheirNumber) {
    EXPECT_NEAR(entropy_nats(std::vector<double>(7, 3.0)), std::log(7.0), 1e-14);
    EXPECT_NEAR(entropy_nats(std::vector<double>(100000, 1e-9)), std::log(1e5), 1e-9);
}

TEST(Entropy, OfOneShareIsZeroAndSoIsThatOfNothing) {
    EXPECT_EQ(entropy_nats(std::vector<double>{0.0, 5.0, 0.0}), 0.0);
    EXPECT_EQ(entropy_nats(std::vector<double>{0.0, 0.0}), 0.0);
    EXPECT_EQ(entropy_nats(std::vector<double>{}), 0.0);
}

// Shannon's example: 1/2, 1/3, 1/6 have 1.4591 bits.
TEST(Entropy, OfShannonsExample) {
    EXPECT_NEAR(entropy_nats(std::vector<double>{3.0, 2.0, 1.0}) / std::log(2.0), 1.4591479, 1e-7);
}

}  // namespace
}  // namespace hepatica
