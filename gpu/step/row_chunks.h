// SPDX-License-Identifier: GPL-3.0-or-later
// Divides the rows of a matrix into chunks, each multiplied by one block of threads
// (RowChunksView).
#pragma once

#include <span>
#include <vector>

namespace hepatica::gpu {

struct RowChunks {
    std::vector<int> begin, entry;  // first row and entry of each chunk, and the ends of the last
    std::vector<unsigned char> row_of;  // row of each entry, counted from its chunk's first
};

// Row i has the entries [row_begin[i], row_begin[i + 1]), with row_begin[0] = 0. Every chunk has at
// least one row, and as many as the limits of RowChunksView allow.
RowChunks chunks_of(std::span<const int> row_begin);

}  // namespace hepatica::gpu
