// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/solvers/block_matrix.h"

#include <algorithm>

#include "core/base/parallel.h"

namespace hepatica {

namespace {
constexpr std::size_t rows_per_block = 256;
}

int BlockMatrix::find(int i, int j) const {
    const auto first = column.begin() + row_begin[i];
    const auto last = column.begin() + row_begin[i + 1];
    const auto found = std::lower_bound(first, last, j);
    return found != last && *found == j ? static_cast<int>(found - column.begin()) : -1;
}

void multiply(const BlockMatrix& matrix, const std::vector<Vec3>& x, std::vector<Vec3>& y) {
    y.resize(x.size());
    parallel_blocks(x.size(), rows_per_block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            Vec3 sum = Vec3::Zero();
            for (int k = matrix.row_begin[i]; k < matrix.row_begin[i + 1]; ++k) {
                sum += matrix.block[k] * x[matrix.column[k]];
            }
            y[i] = sum;
        }
    });
}

}  // namespace hepatica
