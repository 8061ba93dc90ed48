// SPDX-License-Identifier: GPL-3.0-or-later
// Parallel loops over the nodes of a body: copies and dot products of nodal fields, with the same
// bits for any number of threads. The blocks are large enough that a small body runs on one thread.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/base/parallel.h"
#include "core/base/vector.h"

namespace hepatica {

constexpr std::size_t nodes_per_block = 2048;

// Calls visit(i) for i in [0, count), in parallel.
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

// Gives `to` the size and the values of `from`.
inline void copy_nodes(const std::vector<Vec3>& from, std::vector<Vec3>& to) {
    to.resize(from.size());
    for_each_node(from.size(), [&](std::size_t i) { to[i] = from[i]; });
}

// Sum of a[i] . b[i]; the sizes must be equal.
inline double dot(std::span<const Vec3> a, std::span<const Vec3> b) {
    return sum_over_nodes(a.size(), [&](std::size_t i) { return a[i].dot(b[i]); });
}

}  // namespace hepatica
