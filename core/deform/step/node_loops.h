// SPDX-License-Identifier: GPL-3.0-or-later
// Loops over the nodes of a body that several threads share, with the same bits for any number of
// them. The blocks are so large that a small body never pays for waking a thread.
#pragma once

#include <cstddef>

#include "core/base/parallel.h"

namespace hepatica {

constexpr std::size_t nodes_per_block = 2048;

// visit(i) for i in [0, count).
template <class Visit>
void for_each_node(std::size_t count, const Visit& visit) {
    parallel_blocks(count, nodes_per_block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) visit(i);
    });
}

// Sum of term(i) over [0, count).
template <class Term>
double sum_over_nodes(std::size_t count, const Term& term) {
    return parallel_sum(count, nodes_per_block, [&](std::size_t begin, std::size_t end) {
        double sum = 0.0;
        for (std::size_t i = begin; i < end; ++i) sum += term(i);
        return sum;
    });
}

}  // namespace hepatica
