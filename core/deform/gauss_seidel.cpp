// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/gauss_seidel.h"

#include <algorithm>

#include "core/base/parallel.h"
#include "core/deform/block_jacobi.h"

namespace hepatica {

namespace {
constexpr int vertices_per_chunk = 128;
}

GaussSeidel::GaussSeidel(const BlockMatrix& pattern, std::span<const int> order) {
    const int count = static_cast<int>(order.size());
    const int chunks = (count + vertices_per_chunk - 1) / vertices_per_chunk;
    std::vector<int> chunk_of(order.size());
    for (int k = 0; k < count; ++k) chunk_of[order[k]] = k / vertices_per_chunk;
    std::vector<int> colour(static_cast<std::size_t>(chunks), -1);
    int colours = 0;
    for (int c = 0; c < chunks; ++c) {
        std::vector<char> taken(static_cast<std::size_t>(colours) + 1, 0);
        for (int k = c * vertices_per_chunk; k < std::min(count, (c + 1) * vertices_per_chunk);
             ++k) {
            const int v = order[k];
            for (int n = pattern.row_begin[v]; n < pattern.row_begin[v + 1]; ++n) {
                const int other = colour[chunk_of[pattern.column[n]]];
                if (other >= 0) taken[other] = 1;
            }
        }
        colour[c] = static_cast<int>(std::find(taken.begin(), taken.end(), 0) - taken.begin());
        colours = std::max(colours, colour[c] + 1);
    }
    position_.resize(order.size());
    for (int wanted = 0; wanted < colours; ++wanted) {
        colour_begin_.push_back(static_cast<int>(chunks_.size()));
        for (int c = 0; c < chunks; ++c) {
            if (colour[c] != wanted) continue;
            Chunk chunk;
            chunk.begin = static_cast<int>(order_.size());
            for (int k = c * vertices_per_chunk; k < std::min(count, (c + 1) * vertices_per_chunk);
                 ++k) {
                position_[order[k]] = static_cast<int>(order_.size());
                order_.push_back(order[k]);
            }
            chunk.end = static_cast<int>(order_.size());
            chunks_.push_back(chunk);
        }
    }
    colour_begin_.push_back(static_cast<int>(chunks_.size()));
}

void GaussSeidel::prepare(const BlockMatrix& matrix) {
    matrix_ = &matrix;
    inverse_ = inverse_diagonal(matrix);
}

void GaussSeidel::forward(std::span<const Vec3> r, std::span<Vec3> z,
                          std::span<Vec3> remainder) const {
    const BlockMatrix& a = *matrix_;
    for (std::size_t colour = 0; colour + 1 < colour_begin_.size(); ++colour) {
        const int first = colour_begin_[colour];
        const int chunks = colour_begin_[colour + 1] - first;
        parallel_blocks(static_cast<std::size_t>(chunks), 1, [&](std::size_t c, std::size_t) {
            const Chunk chunk = chunks_[first + static_cast<int>(c)];
            for (int p = chunk.begin; p < chunk.end; ++p) {
                const int v = order_[p];
                Vec3 sum = r[v];
                for (int k = a.row_begin[v]; k < a.row_begin[v + 1]; ++k) {
                    const int w = a.column[k];
                    if (position_[w] < p) sum -= a.block[k] * z[w];
                }
                z[v] = inverse_[v] * sum;
            }
        });
    }
    // Row v was satisfied when it was swept: what is left is the part of the later vertices.
    parallel_blocks(order_.size(), 256, [&](std::size_t begin, std::size_t end) {
        for (std::size_t p = begin; p < end; ++p) {
            const int v = order_[p];
            Vec3 sum = Vec3::Zero();
            for (int k = a.row_begin[v]; k < a.row_begin[v + 1]; ++k) {
                const int w = a.column[k];
                if (position_[w] > static_cast<int>(p)) sum -= a.block[k] * z[w];
            }
            remainder[v] = sum;
        }
    });
}

void GaussSeidel::backward(std::span<const Vec3> r, std::span<Vec3> z) const {
    const BlockMatrix& a = *matrix_;
    for (std::size_t colour = colour_begin_.size() - 1; colour-- > 0;) {
        const int first = colour_begin_[colour];
        const int chunks = colour_begin_[colour + 1] - first;
        parallel_blocks(static_cast<std::size_t>(chunks), 1, [&](std::size_t c, std::size_t) {
            const Chunk chunk = chunks_[first + static_cast<int>(c)];
            for (int p = chunk.end; p-- > chunk.begin;) {
                const int v = order_[p];
                Vec3 sum = r[v];
                for (int k = a.row_begin[v]; k < a.row_begin[v + 1]; ++k) {
                    sum -= a.block[k] * z[a.column[k]];
                }
                z[v] += inverse_[v] * sum;
            }
        });
    }
}

}  // namespace hepatica
