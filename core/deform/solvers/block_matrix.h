// SPDX-License-Identifier: GPL-3.0-or-later
// Symmetric sparse matrix of 3x3 blocks, one block row per vertex: the system matrix A = M + dt B +
// dt^2 K of eq. (12), in the format that assembly writes and every linear solver reads.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/base/vector.h"

namespace hepatica {

// Block compressed rows with both triangles stored: row i holds the blocks [row_begin[i],
// row_begin[i+1]), columns ascending, including the diagonal block. block(i,j) ==
// block(j,i).transpose() to the last bit.
struct BlockMatrix {
    std::vector<int> row_begin{0};
    std::vector<int> column;
    std::vector<Mat3> block;
    std::vector<int> diagonal;  // index of each row's diagonal block
    // 1: all off-diagonal blocks of this row are zero, so that products skip them. Empty: unknown
    // for every row.
    std::vector<std::uint8_t> alone;

    int rows() const { return static_cast<int>(row_begin.size()) - 1; }
    // Index of block (i, j), or -1 where it is not in the pattern. O(log blocks in the row).
    int find(int i, int j) const;
};

// y = A x. The same bits for any number of threads.
// Thread safety: const access only.
void multiply(const BlockMatrix& matrix, const std::vector<Vec3>& x, std::vector<Vec3>& y);

}  // namespace hepatica
