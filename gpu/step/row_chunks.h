// SPDX-License-Identifier: GPL-3.0-or-later
// Cuts the rows of a matrix into chunks that a block of threads multiplies at once (RowChunksView).
#pragma once

#include <span>
#include <vector>

namespace hepatica::gpu {

struct RowChunks {
    std::vector<int> begin, entry;      // its first row and entry, and the ends of the last chunk
    std::vector<unsigned char> row_of;  // of each entry, counted from its chunk's first
};

// Row i has the entries [row_begin[i], row_begin[i + 1]); the first of all is 0. Every chunk has a
// row or more, and as many as the limits of RowChunksView allow.
RowChunks chunks_of(std::span<const int> row_begin);

}  // namespace hepatica::gpu
