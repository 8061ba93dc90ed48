// SPDX-License-Identifier: GPL-3.0-or-later
// Block Gauss-Seidel sweeps that run in parallel and give the same bits for any number of threads:
// vertices in the order of the tree are cut into chunks, and chunks that touch have different
// colours.
#pragma once

#include <span>
#include <vector>

#include "core/deform/block_matrix.h"

namespace hepatica {

class GaussSeidel {
  public:
    // `order` keeps neighbours close together; any permutation will do.
    GaussSeidel(const BlockMatrix& pattern, std::span<const int> order);

    void prepare(const BlockMatrix& matrix);

    // z = (D + L)^-1 r, a sweep from zero, and remainder = r - A z.
    void forward(std::span<const Vec3> r, std::span<Vec3> z, std::span<Vec3> remainder) const;

    // The adjoint sweep, in reverse order, from the given z.
    void backward(std::span<const Vec3> r, std::span<Vec3> z) const;

    int colours() const { return static_cast<int>(colour_begin_.size()) - 1; }

  private:
    struct Chunk {
        int begin = 0;  // into order_
        int end = 0;
    };

    const BlockMatrix* matrix_ = nullptr;
    std::vector<int> order_;
    std::vector<int> position_;  // when a vertex is swept; later colours later
    std::vector<Chunk> chunks_;  // sorted by colour
    std::vector<int> colour_begin_;
    std::vector<Mat3> inverse_;
};

}  // namespace hepatica
