// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/parallel.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <vector>

namespace hepatica {
namespace {

TEST(Parallel, VisitsEveryIndexOnce) {
    for (const std::size_t count : {0u, 1u, 63u, 64u, 65u, 10007u}) {
        std::vector<int> visits(count, 0);
        parallel_blocks(count, 64, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) ++visits[i];
        });
        EXPECT_EQ(visits, std::vector<int>(count, 1));
    }
}

TEST(Parallel, SumsToTheSameBitsForAnyNumberOfThreads) {
    const auto sum = [](int threads) {
        const ThreadLimit limit(threads);
        return parallel_sum(100'003, 1000, [](std::size_t begin, std::size_t end) {
            double s = 0.0;
            for (std::size_t i = begin; i < end; ++i) s += std::sin(static_cast<double>(i)) / 3.0;
            return s;
        });
    };
    const double one = sum(1);
    EXPECT_EQ(one, sum(2));
    EXPECT_EQ(one, sum(4));
}

TEST(Parallel, HandsAnExceptionToTheCaller) {
    EXPECT_THROW(parallel_blocks(1000, 10,
                                 [](std::size_t begin, std::size_t) {
                                     if (begin == 500) throw std::runtime_error("block 50");
                                 }),
                 std::runtime_error);
}

}  // namespace
}  // namespace hepatica
