// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/solvers/block_matrix.h"

#include <algorithm>
#include <cstring>

#include "core/base/parallel.h"

namespace hepatica {

namespace {
constexpr std::size_t product_rows_per_block = 256;
}

int BlockMatrix::find(int i, int j) const {
    const auto first = column.begin() + row_begin[i];
    const auto last = column.begin() + row_begin[i + 1];
    const auto found = std::lower_bound(first, last, j);
    return found != last && *found == j ? static_cast<int>(found - column.begin()) : -1;
}

namespace {

using Wide = double __attribute__((vector_size(32)));

Wide load(const double* p) {
    Wide value;
    std::memcpy(&value, p, sizeof value);
    return value;
}

// block * x in the first three lanes; nothing beyond the block is read.
Wide times(const Mat3& block, const Vec3& x) {
    const Wide from_fifth = load(block.data() + 5);
    const Wide last = __builtin_shufflevector(from_fifth, from_fifth, 1, 2, 3, 0);
    return load(block.data()) * x[0] + load(block.data() + 3) * x[1] + last * x[2];
}

}  // namespace

void multiply(const BlockMatrix& matrix, const std::vector<Vec3>& x, std::vector<Vec3>& y) {
    y.resize(x.size());
    parallel_blocks(x.size(), product_rows_per_block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const bool alone = !matrix.alone.empty() && matrix.alone[i] != 0;
            const int first = alone ? matrix.diagonal[i] : matrix.row_begin[i];
            const int last = alone ? first + 1 : matrix.row_begin[i + 1];
            Wide sum{};
            for (int k = first; k < last; ++k) sum += times(matrix.block[k], x[matrix.column[k]]);
            y[i] = Vec3(sum[0], sum[1], sum[2]);
        }
    });
}

}  // namespace hepatica
