// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/moving_mean.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <random>
#include <vector>

namespace hepatica {
namespace {

// Against the mean of the last samples, summed anew each time, with zeros before the first.
TEST(MovingMean, IsTheMeanOfTheLastSamples) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> sample(-1e3, 1e3);
    for (const std::size_t steps : {1u, 2u, 6u, 17u}) {
        MovingMean mean(0.01 * static_cast<double>(steps), 0.01);
        std::vector<double> taken(steps, 0.0);
        for (int k = 0; k < 100; ++k) {
            taken.push_back(sample(random));
            double sum = 0.0;
            for (std::size_t i = taken.size() - steps; i < taken.size(); ++i) sum += taken[i];
            EXPECT_NEAR(mean.take(taken.back()), sum / static_cast<double>(steps), 1e-9);
        }
    }
}

TEST(MovingMean, OfAShorterSpanThanAStepIsTheSampleItself) {
    MovingMean mean(0.001, 0.5);
    EXPECT_EQ(mean.take(3.0), 3.0);
    EXPECT_EQ(mean.take(-7.0), -7.0);
}

// No rounding of what is long gone stays behind.
TEST(MovingMean, ComesBackToZeroExactly) {
    MovingMean mean(0.3, 0.1);
    mean.take(1e17);
    mean.take(0.1);
    mean.take(1.0 / 3.0);
    mean.take(0.0);
    mean.take(0.0);
    EXPECT_EQ(mean.take(0.0), 0.0);
}

}  // namespace
}  // namespace hepatica
