// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/solvers/gauss_seidel.h"

#include <Eigen/LU>
#include <algorithm>
#include <cstring>

#include "core/base/parallel.h"

namespace hepatica {

namespace {

constexpr int vertices_per_chunk = 128;
constexpr std::size_t sweep_rows_per_block = 512;

// A colour for each chunk of consecutive rows, such that chunks with a block in common differ.
std::vector<int> colour_chunks(const BlockMatrix& pattern, std::span<const int> order) {
    const int count = static_cast<int>(order.size());
    std::vector<int> chunk_of(order.size());
    for (int k = 0; k < count; ++k) chunk_of[order[k]] = k / vertices_per_chunk;
    std::vector<int> colour(
        static_cast<std::size_t>((count + vertices_per_chunk - 1) / vertices_per_chunk), -1);
    for (int begin = 0; begin < count; begin += vertices_per_chunk) {
        std::vector<char> taken;
        for (int k = begin; k < std::min(count, begin + vertices_per_chunk); ++k) {
            const int v = order[k];
            for (int n = pattern.row_begin[v]; n < pattern.row_begin[v + 1]; ++n) {
                const int other = colour[chunk_of[pattern.column[n]]];
                if (other < 0) continue;
                if (static_cast<int>(taken.size()) <= other) taken.resize(other + 1, 0);
                taken[other] = 1;
            }
        }
        colour[begin / vertices_per_chunk] =
            static_cast<int>(std::find(taken.begin(), taken.end(), 0) - taken.begin());
    }
    return colour;
}

}  // namespace

GaussSeidel::GaussSeidel(const BlockMatrix& pattern, std::span<const int> order) {
    const int count = static_cast<int>(order.size());
    const std::vector<int> colour = colour_chunks(pattern, order);
    const int colours = colour.empty() ? 0 : 1 + *std::max_element(colour.begin(), colour.end());
    for (int wanted = 0; wanted < colours; ++wanted) {
        colour_begin_.push_back(static_cast<int>(chunks_.size()));
        for (int c = 0; c < static_cast<int>(colour.size()); ++c) {
            if (colour[c] != wanted) continue;
            Chunk chunk;
            chunk.begin = static_cast<int>(vertex_.size());
            for (int k = c * vertices_per_chunk; k < std::min(count, (c + 1) * vertices_per_chunk);
                 ++k) {
                vertex_.push_back(order[k]);
            }
            chunk.end = static_cast<int>(vertex_.size());
            chunks_.push_back(chunk);
        }
    }
    colour_begin_.push_back(static_cast<int>(chunks_.size()));

    std::vector<int> row_of(order.size());
    for (int p = 0; p < count; ++p) row_of[vertex_[p]] = p;
    row_begin_.push_back(0);
    for (int p = 0; p < count; ++p) {
        const int v = vertex_[p];
        for (const bool after : {false, true}) {
            if (after) row_middle_.push_back(static_cast<int>(column_.size()));
            for (int k = pattern.row_begin[v]; k < pattern.row_begin[v + 1]; ++k) {
                const int other = row_of[pattern.column[k]];
                if (other == p || (other > p) != after) continue;
                column_.push_back(other);
                source_.push_back(k);
            }
        }
        row_begin_.push_back(static_cast<int>(column_.size()));
    }
    block_.resize(column_.size());
    inverse_.resize(order.size());
    row_sum_.resize(order.size());
    z_.resize(order.size());
}

void GaussSeidel::prepare_rows(const BlockMatrix& matrix, std::size_t begin, std::size_t end) {
    for (std::size_t p = begin; p < end; ++p) {
        Mat3 sum = matrix.block[matrix.diagonal[vertex_[p]]];
        Mat3 single_sum = Mat3::Zero();
        for (int k = row_begin_[p]; k < row_begin_[p + 1]; ++k) {
            const Mat3& block = matrix.block[source_[k]];
            sum += block;
            const Eigen::Matrix3f single = block.cast<float>();
            single_sum += single.cast<double>();
            for (int c = 0; c < 3; ++c) {
                for (int r = 0; r < 3; ++r) block_[k].entry[4 * c + r] = single(r, c);
                block_[k].entry[4 * c + 3] = 0.0f;
            }
        }
        row_sum_[p] = sum;
        const Mat3 diagonal = sum - single_sum;
        inverse_[p] = diagonal.inverse();
        if (!(diagonal.determinant() > 0.0) || !inverse_[p].allFinite()) inverse_[p].setZero();
    }
}

void GaussSeidel::prepare(const BlockMatrix& matrix) {
    parallel_blocks(vertex_.size(), sweep_rows_per_block,
                    [&](std::size_t begin, std::size_t end) { prepare_rows(matrix, begin, end); });
}

namespace {

using Wide = double __attribute__((vector_size(32)));
using WideSingle = float __attribute__((vector_size(16)));

Wide widen(const float* p) {
    WideSingle value;
    std::memcpy(&value, p, sizeof value);
    return __builtin_convertvector(value, Wide);
}

Wide times(const float* block, const Wide& x) {
    return widen(block) * x[0] + widen(block + 4) * x[1] + widen(block + 8) * x[2];
}

Vec3 narrow(const Wide& x) {
    return {x[0], x[1], x[2]};
}
Wide widen(const Vec3& x) {
    return Wide{x.x(), x.y(), x.z(), 0.0};
}

}  // namespace

template <class Visit>
void GaussSeidel::for_each_chunk(int colour, const Visit& visit) const {
    const int first = colour_begin_[colour];
    const int chunks = colour_begin_[colour + 1] - first;
    parallel_blocks(static_cast<std::size_t>(chunks), 1, [&](std::size_t c, std::size_t) {
        visit(chunks_[first + static_cast<int>(c)]);
    });
}

void GaussSeidel::forward(std::span<const Vec3> r, std::span<Vec3> z, std::span<Vec3> remainder) {
    for (int colour = 0; colour < colours(); ++colour) {
        for_each_chunk(colour, [&](const Chunk& chunk) {
            for (int p = chunk.begin; p < chunk.end; ++p) {
                Wide sum{};
                for (int k = row_begin_[p]; k < row_middle_[p]; ++k) {
                    sum += times(block_[k].entry, z_[column_[k]]);
                }
                const Vec3 value = inverse_[p] * (r[vertex_[p]] - narrow(sum));
                z_[p] = widen(value);
                z[vertex_[p]] = value;
            }
        });
    }
    // The residual of row p was zero when it was swept; now only later rows contribute to it.
    parallel_blocks(vertex_.size(), sweep_rows_per_block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t p = begin; p < end; ++p) {
            Wide sum{};
            for (int k = row_middle_[p]; k < row_begin_[p + 1]; ++k) {
                sum -= times(block_[k].entry, z_[column_[k]]);
            }
            remainder[vertex_[p]] = narrow(sum);
        }
    });
}

void GaussSeidel::backward(std::span<const Vec3> r, std::span<Vec3> z) {
    parallel_blocks(vertex_.size(), sweep_rows_per_block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t p = begin; p < end; ++p) z_[p] = widen(z[vertex_[p]]);
    });
    for (int colour = colours(); colour-- > 0;) {
        for_each_chunk(colour, [&](const Chunk& chunk) {
            for (int p = chunk.end; p-- > chunk.begin;) {
                const Wide own = z_[p];
                Wide sum{};
                for (int k = row_begin_[p]; k < row_begin_[p + 1]; ++k) {
                    sum += times(block_[k].entry, z_[column_[k]] - own);
                }
                const Vec3 before = narrow(own);
                const Vec3 left = r[vertex_[p]] - row_sum_[p] * before - narrow(sum);
                const Vec3 value = before + inverse_[p] * left;
                z_[p] = widen(value);
                z[vertex_[p]] = value;
            }
        });
    }
}

}  // namespace hepatica
