// SPDX-License-Identifier: GPL-3.0-or-later
// The stiffness J^T k J of a force between points of two features of a surface, where J is the
// weighted mean of the first feature's nodes minus that of the second's. Blocks within one feature
// exist in every matrix of the body, because a face belongs to one element. Blocks between the two
// features do not: they are the coupling, which is only applied to vectors. Held nodes do not move.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "core/base/vector.h"
#include "core/deform/solvers/block_matrix.h"
#include "core/deform/solvers/coupling_blocks.h"

namespace hepatica {

// Weights are > 0 on the first feature and < 0 on the second; their sums are 1 and -1.
struct PointPair {
    std::array<int, 4> nodes{};
    std::array<double, 4> weights{};
    int in_first = 1;  // how many nodes belong to the first feature

    bool within_one(int a, int b) const { return (a < in_first) == (b < in_first); }
    // From the second point to the first.
    Vec3 between(std::span<const Vec3> x) const {
        Vec3 sum = Vec3::Zero();
        for (int a = 0; a < 4; ++a) sum += weights[a] * x[nodes[a]];
        return sum;
    }
    // Adds `force` at the first point and its opposite at the second.
    void add_force(const Vec3& force, std::span<Vec3> forces) const {
        for (int a = 0; a < 4; ++a) forces[nodes[a]] += weights[a] * force;
    }
};

inline bool stays(std::span<const std::uint8_t> held, int node) {
    return !held.empty() && held[node] != 0;
}

inline void add_within(const PointPair& pair, const Mat3& stiffness,
                       std::span<const std::uint8_t> held, BlockMatrix& matrix) {
    for (int a = 0; a < 4; ++a)
        for (int b = 0; b < 4; ++b) {
            const int i = pair.nodes[a], j = pair.nodes[b];
            if (!pair.within_one(a, b) || stays(held, i) || stays(held, j)) continue;
            matrix.block[matrix.find(i, j)] += pair.weights[a] * pair.weights[b] * stiffness;
        }
}

// `within`: the blocks within each feature, as add_within(); otherwise the coupling. d of held
// nodes is taken as 0.
inline void add_pair_product(const PointPair& pair, const Mat3& stiffness, bool within,
                             std::span<const std::uint8_t> held, std::span<const Vec3> d,
                             std::span<Vec3> product) {
    std::array<Vec3, 2> moved{Vec3::Zero(), Vec3::Zero()};
    for (int a = 0; a < 4; ++a)
        if (!stays(held, pair.nodes[a]))
            moved[a < pair.in_first ? 0 : 1] += pair.weights[a] * d[pair.nodes[a]];
    const Vec3 first = stiffness * moved[within ? 0 : 1],
               second = stiffness * moved[within ? 1 : 0];
    for (int a = 0; a < 4; ++a)
        if (!stays(held, pair.nodes[a]))
            product[pair.nodes[a]] += pair.weights[a] * (a < pair.in_first ? first : second);
}

// Appends the blocks of the coupling, including those of nodes with weight 0, so that their pattern
// changes only when the touching pairs do.
inline void append_pair_coupling(const PointPair& pair, const Mat3& stiffness,
                                 std::span<const std::uint8_t> held, CouplingBlocks& blocks) {
    PairCoupling own;
    for (int a = 0; a < pair.in_first; ++a)
        for (int b = pair.in_first; b < 4; ++b)
            if (const int i = pair.nodes[a], j = pair.nodes[b]; !stays(held, i) && !stays(held, j))
                own.blocks[own.count++] = {i, j, pair.weights[a] * pair.weights[b] * stiffness};
    if (own.count > 0) blocks.push_back(own);
}

}  // namespace hepatica
