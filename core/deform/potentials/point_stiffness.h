// SPDX-License-Identifier: GPL-3.0-or-later
// The stiffness J^T k J of a force on one point of a triangle, where J are the weights of the
// corners: added to a matrix that has the blocks of every pair of corners, or multiplied by a
// vector. Rows and columns of nodes with held[i] != 0, which do not move, are left out of the
// matrix.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "core/base/vector.h"
#include "core/deform/solvers/block_matrix.h"

namespace hepatica {

inline void add_point_stiffness(const std::array<int, 3>& nodes,
                                const std::array<double, 3>& weights, const Mat3& stiffness,
                                std::span<const std::uint8_t> held, BlockMatrix& matrix) {
    const auto stays = [&](int node) { return !held.empty() && held[node] != 0; };
    for (int a = 0; a < 3; ++a)
        for (int b = 0; b < 3; ++b)
            if (!stays(nodes[a]) && !stays(nodes[b]))
                matrix.block[matrix.find(nodes[a], nodes[b])] +=
                    weights[a] * weights[b] * stiffness;
}

inline void add_point_product(const std::array<int, 3>& nodes, const std::array<double, 3>& weights,
                              const Mat3& stiffness, std::span<const Vec3> d,
                              std::span<Vec3> product) {
    Vec3 moved = Vec3::Zero();
    for (int a = 0; a < 3; ++a) moved += weights[a] * d[nodes[a]];
    const Vec3 force = stiffness * moved;
    for (int a = 0; a < 3; ++a) product[nodes[a]] += weights[a] * force;
}

}  // namespace hepatica
