// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/median.h"

#include <gtest/gtest.h>

#include <random>

namespace hepatica {
namespace {

TEST(Median, IsTheMiddleOfTheSortedValues) {
    EXPECT_EQ(median(std::vector<int>{7}), 7);
    EXPECT_EQ(median(std::vector<int>{3, 1}), 3);  // the upper of two
    EXPECT_EQ(median(std::vector<int>{9, 1, 5}), 5);
    EXPECT_EQ(median(std::vector<double>{4, 1, 3, 2}), 3.0);
    std::mt19937_64 random(3);
    for (std::size_t size = 1; size < 60; ++size) {
        std::vector<int> values(size);
        for (int& v : values) v = static_cast<int>(random() % 20);
        const int found = median(values);
        std::ranges::sort(values);
        EXPECT_EQ(found, values[size / 2]);
    }
}

}  // namespace
}  // namespace hepatica
