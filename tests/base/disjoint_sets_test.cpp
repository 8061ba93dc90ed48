// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/disjoint_sets.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace hepatica {
namespace {

// Against labels that are rewritten one by one.
TEST(DisjointSets, AgreeWithLabelsForRandomUnions) {
    std::mt19937 random(5);
    const auto below = [&](std::uint32_t size) {
        return static_cast<std::uint32_t>(random() % size);
    };
    for (int trial = 0; trial < 50; ++trial) {
        const std::uint32_t size = 1 + below(40);
        DisjointSets sets(size);
        std::vector<std::uint32_t> labels(size);
        for (std::uint32_t i = 0; i < size; ++i) labels[i] = i;
        std::size_t count = size;
        for (std::uint32_t step = 0; step < size; ++step) {
            const std::uint32_t a = below(size), b = below(size);
            const std::uint32_t low = std::min(labels[a], labels[b]);
            const std::uint32_t high = std::max(labels[a], labels[b]);
            EXPECT_EQ(sets.unite(a, b), low != high);
            if (low != high) --count;
            for (std::uint32_t& label : labels)
                if (label == high) label = low;
            EXPECT_EQ(sets.count(), count);
            for (std::uint32_t i = 0; i < size; ++i) EXPECT_EQ(sets.root(i), labels[i]);
        }
    }
}

TEST(DisjointSets, GrowByOneMember) {
    DisjointSets sets;
    EXPECT_EQ(sets.add(), 0u);
    EXPECT_EQ(sets.add(), 1u);
    EXPECT_EQ(sets.size(), 2u);
    EXPECT_TRUE(sets.unite(1, 0));
    EXPECT_EQ(sets.root(1), 0u);
    EXPECT_EQ(sets.count(), 1u);
}

}  // namespace
}  // namespace hepatica
