// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/parallel.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>
#include <stdexcept>
#include <thread>
#include <utility>
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

// Sums are the same for any number of threads because their blocks are.
TEST(Parallel, CutsTheRangeIntoBlocksOfTheSizeAskedFor) {
    using Blocks = std::vector<std::pair<std::size_t, std::size_t>>;
    const auto blocks_of = [](std::size_t count) {
        std::mutex mutex;
        Blocks blocks;
        parallel_blocks(count, 64, [&](std::size_t begin, std::size_t end) {
            const std::lock_guard lock(mutex);
            blocks.emplace_back(begin, end);
        });
        std::ranges::sort(blocks);
        return blocks;
    };
    EXPECT_EQ(blocks_of(0), Blocks{});
    EXPECT_EQ(blocks_of(63), (Blocks{{0, 63}}));
    EXPECT_EQ(blocks_of(64), (Blocks{{0, 64}}));
    EXPECT_EQ(blocks_of(129), (Blocks{{0, 64}, {64, 128}, {128, 129}}));
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

// Loops within loops, from several threads at once, over and over: each index is visited once, and
// nobody waits for a helper who never comes.
TEST(Parallel, LoopsMayBeginLoops) {
    std::atomic<int> visits{0};
    const auto play = [&] {
        for (int round = 0; round < 200; ++round)
            parallel_blocks(8, 1, [&](std::size_t, std::size_t) {
                parallel_blocks(16, 4, [&](std::size_t begin, std::size_t end) {
                    visits += static_cast<int>(end - begin);
                });
            });
    };
    for (const int threads : {1, 2, 5}) {
        const ThreadLimit limit(threads);
        visits = 0;
        {
            const std::jthread other(play);
            play();
        }
        EXPECT_EQ(visits, 2 * 200 * 8 * 16) << threads;
    }
}

}  // namespace
}  // namespace hepatica
