// SPDX-License-Identifier: GPL-3.0-or-later
// Stiffness between nodes that share no element, as blocks outside the matrix: C of coupled_solve.h
// and coupled_factor.h.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "core/base/vector.h"

namespace hepatica {

// A symmetric block, at (first, second) and (second, first).
struct CouplingBlock {
    int first = 0, second = 0;  // two nodes, first != second
    Mat3 block = Mat3::Zero();
};

// The blocks between two touching features. Together with the blocks within each feature they are
// positive semidefinite; some of them alone need not be.
struct PairCoupling {
    std::array<CouplingBlock, 4> blocks{};
    int count = 0;

    std::span<const CouplingBlock> all() const {
        return std::span(blocks).first(static_cast<std::size_t>(count));
    }
};

// Several blocks for the same two nodes count as their sum.
using CouplingBlocks = std::vector<PairCoupling>;

// product += C d.
inline void add_product(const CouplingBlocks& coupling, std::span<const Vec3> d,
                        std::span<Vec3> product) {
    for (const PairCoupling& pair : coupling)
        for (const CouplingBlock& c : pair.all()) {
            product[c.first] += c.block * d[c.second];
            product[c.second] += c.block * d[c.first];
        }
}

}  // namespace hepatica
