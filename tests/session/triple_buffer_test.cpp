// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/triple_buffer.h"

#include <gtest/gtest.h>

#include <thread>
#include <vector>

namespace hepatica {
namespace {

TEST(TripleBuffer, HandsOverTheNewestAndOnlyOnce) {
    TripleBuffer<int> buffer;
    EXPECT_FALSE(buffer.update());
    for (const int value : {1, 2, 3}) {
        buffer.back() = value;
        buffer.publish();
    }
    EXPECT_TRUE(buffer.update());
    EXPECT_EQ(buffer.front(), 3);
    EXPECT_FALSE(buffer.update());
    EXPECT_EQ(buffer.front(), 3);
}

TEST(TripleBuffer, WhatIsReadStaysWhateverIsWrittenMeanwhile) {
    TripleBuffer<int> buffer;
    for (int value = 1; value < 20; ++value) {
        buffer.back() = value;
        buffer.publish();
        EXPECT_TRUE(buffer.update());
        for (int later = 0; later <= value % 4; ++later) {
            buffer.back() = 100;
            EXPECT_EQ(buffer.front(), value) << later << " were published since";
            buffer.publish();
            EXPECT_EQ(buffer.front(), value);
        }
        EXPECT_TRUE(buffer.update());
        EXPECT_EQ(buffer.front(), 100);
    }
}

// A torn or reordered value would show as entries that differ or a number that falls. Run it under
// the thread sanitizer too (preset tsan).
TEST(TripleBuffer, NeverTearsAndNeverGoesBackBetweenTwoThreads) {
    constexpr int last = 200'000;
    TripleBuffer<std::vector<int>> buffer;
    std::jthread writer([&] {
        for (int value = 1; value <= last; ++value) {
            buffer.back().assign(16, value);
            buffer.publish();
        }
    });
    int seen = 0;
    while (seen < last) {
        if (!buffer.update()) continue;
        const std::vector<int>& values = buffer.front();
        ASSERT_EQ(values.size(), 16u);
        for (const int value : values) ASSERT_EQ(value, values.front());
        ASSERT_GT(values.front(), seen);
        seen = values.front();
    }
}

}  // namespace
}  // namespace hepatica
