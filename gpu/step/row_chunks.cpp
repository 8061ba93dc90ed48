// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/step/row_chunks.h"

#include "gpu/kernels/system_kernels.h"

namespace hepatica::gpu {

RowChunks chunks_of(std::span<const int> row_begin) {
    using Limits = RowChunksView;
    const int rows = static_cast<int>(row_begin.size()) - 1;
    RowChunks chunks{.begin = {0}, .entry = {}, .row_of = {}};
    chunks.row_of.reserve(static_cast<std::size_t>(row_begin.back()));
    for (int i = 0; i < rows; ++i) {
        const int first = chunks.begin.back();
        const bool full = i - first == Limits::most_rows ||
                          row_begin[i + 1] - row_begin[first] > Limits::most_entries;
        if (full && i > first) chunks.begin.push_back(i);
        chunks.row_of.resize(static_cast<std::size_t>(row_begin[i + 1]),
                             static_cast<unsigned char>(i - chunks.begin.back()));
    }
    if (rows > 0) chunks.begin.push_back(rows);
    for (const int row : chunks.begin) chunks.entry.push_back(row_begin[row]);
    return chunks;
}

}  // namespace hepatica::gpu
