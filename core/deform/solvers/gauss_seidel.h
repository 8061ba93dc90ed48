// SPDX-License-Identifier: GPL-3.0-or-later
// Block Gauss-Seidel sweeps that run in parallel and give the same bits for any number of threads:
// vertices in the order of the tree are cut into chunks, and adjacent chunks have different
// colours. Off-diagonal blocks are in single precision. A row is applied to differences, R_i z_i +
// sum_j A_ij (z_j - z_i) with the row sum R_i in double precision, so that the rounding of stiff
// blocks does not affect the motion of a long thin body as a whole.
#pragma once

#include <span>
#include <vector>

#include "core/deform/solvers/block_matrix.h"

namespace hepatica {

class GaussSeidel {
  public:
    // `order` is a permutation; the sweep converges faster where neighbours are close in it.
    GaussSeidel(const BlockMatrix& pattern, std::span<const int> order);

    // Takes the values of a matrix with that pattern.
    void prepare(const BlockMatrix& matrix);

    // z = (D + L)^-1 r, a forward sweep from zero; remainder = r - A z.
    void forward(std::span<const Vec3> r, std::span<Vec3> z, std::span<Vec3> remainder);

    // The adjoint sweep, in reverse order, starting from z.
    void backward(std::span<const Vec3> r, std::span<Vec3> z);

    int colours() const { return static_cast<int>(colour_begin_.size()) - 1; }

  private:
    // Four lanes, the last one zero or unused.
    using Wide = double __attribute__((vector_size(32)));
    // Columns of a block, padded to four lanes.
    struct Block {
        float entry[12];
    };
    struct Chunk {
        int begin = 0;  // rows, in the order of the sweep
        int end = 0;
    };

    template <class Visit>
    void for_each_chunk(int colour, const Visit& visit) const;
    void prepare_rows(const BlockMatrix& matrix, std::size_t begin, std::size_t end);

    std::vector<int> vertex_;    // of each row
    std::vector<Chunk> chunks_;  // sorted by colour
    std::vector<int> colour_begin_;
    // Row p: blocks [row_begin_[p], row_middle_[p]) reach rows before it, then rows after it.
    std::vector<int> row_begin_, row_middle_;
    std::vector<int> column_;  // row of each block's column
    std::vector<int> source_;  // index of each block in the matrix
    std::vector<Block> block_;
    std::vector<Mat3> inverse_, row_sum_;
    std::vector<Wide> z_;
};

}  // namespace hepatica
