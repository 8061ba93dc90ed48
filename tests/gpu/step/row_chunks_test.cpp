// SPDX-License-Identifier: GPL-3.0-or-later
// Chunks of rows hold every row and every entry once, keep to their limits, and none of them could
// have taken a row more.
#include "gpu/step/row_chunks.h"

#include <gtest/gtest.h>

#include <random>

#include "gpu/kernels/system_kernels.h"

namespace hepatica {
namespace {

using Limits = gpu::RowChunksView;

// Row beginnings of so many rows with up to `most` entries each.
std::vector<int> random_rows(int rows, int most, std::mt19937& random) {
    std::vector<int> begin{0};
    std::uniform_int_distribution<int> entries(0, most);
    for (int i = 0; i < rows; ++i) begin.push_back(begin.back() + entries(random));
    return begin;
}

void expect_chunks(const std::vector<int>& row_begin) {
    const gpu::RowChunks chunks = gpu::chunks_of(row_begin);
    const int rows = static_cast<int>(row_begin.size()) - 1;
    ASSERT_EQ(chunks.begin.front(), 0);
    ASSERT_EQ(chunks.begin.back(), rows);
    ASSERT_EQ(chunks.row_of.size(), static_cast<std::size_t>(row_begin.back()));
    for (std::size_t c = 0; c + 1 < chunks.begin.size(); ++c) {
        const int first = chunks.begin[c], past = chunks.begin[c + 1];
        const int entries = row_begin[past] - row_begin[first];
        EXPECT_GT(past, first);
        EXPECT_EQ(chunks.entry[c], row_begin[first]);
        EXPECT_EQ(chunks.entry[c + 1], row_begin[past]);
        EXPECT_LE(past - first, Limits::most_rows);
        if (past - first > 1) {
            EXPECT_LE(entries, Limits::most_entries);
        }
        if (past < rows && past - first < Limits::most_rows) {
            EXPECT_GT(row_begin[past + 1] - row_begin[first], Limits::most_entries);
        }
        for (int i = first; i < past; ++i)
            for (int k = row_begin[i]; k < row_begin[i + 1]; ++k)
                ASSERT_EQ(first + chunks.row_of[k], i) << "entry " << k;
    }
}

TEST(RowChunks, HoldEveryRowOnceAndKeepToTheirLimits) {
    std::mt19937 random(20261128);
    for (const int most : {0, 1, 14, 40, 300, 2500})
        for (const int rows : {1, 2, 63, 64, 65, 1000}) {
            SCOPED_TRACE("rows " + std::to_string(rows) + ", entries up to " +
                         std::to_string(most));
            expect_chunks(random_rows(rows, most, random));
        }
}

TEST(RowChunks, NoRowsAreNoChunks) {
    const gpu::RowChunks none = gpu::chunks_of(std::vector<int>{0});
    EXPECT_EQ(none.begin, std::vector<int>{0});
    EXPECT_TRUE(none.row_of.empty());
}

}  // namespace
}  // namespace hepatica
