// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/assembly.h"

#include <algorithm>
#include <array>

#include "core/base/parallel.h"

namespace hepatica {
namespace {

constexpr std::size_t row_block = 256;

}  // namespace

Assembly::Assembly(const Body& body) : body_(body), slots_(body) {
    build_pattern();
    build_gather_lists();
}

void Assembly::build_pattern() {
    std::vector<std::array<int, 2>> entries;
    for (int i = 0; i < body_.node_count(); ++i) entries.push_back({i, i});
    for (const ElementGroup& group : body_.groups) {
        const int n = group.nodes_per_element;
        for (std::size_t first = 0; first < group.connectivity.size(); first += n)
            for (int a = 0; a < n; ++a)
                for (int b = 0; b < n; ++b)
                    if (a != b)
                        entries.push_back(
                            {group.connectivity[first + a], group.connectivity[first + b]});
    }
    std::ranges::sort(entries);
    entries.erase(std::unique(entries.begin(), entries.end()), entries.end());
    pattern_.row_begin.assign(body_.node_count() + 1, 0);
    pattern_.diagonal.resize(body_.node_count());
    for (const auto& [i, j] : entries) {
        if (i == j) pattern_.diagonal[i] = static_cast<int>(pattern_.column.size());
        pattern_.column.push_back(j);
        ++pattern_.row_begin[i + 1];
    }
    for (int i = 0; i < body_.node_count(); ++i) pattern_.row_begin[i + 1] += pattern_.row_begin[i];
    pattern_.block.assign(pattern_.column.size(), Mat3::Zero());
    mirror_.resize(pattern_.column.size());
    for (int i = 0; i < body_.node_count(); ++i)
        for (int k = pattern_.row_begin[i]; k < pattern_.row_begin[i + 1]; ++k)
            mirror_[k] = pattern_.find(pattern_.column[k], i);
}

void Assembly::build_gather_lists() {
    std::vector<std::vector<int>> of_node(body_.node_count());
    // What an element wrote from the higher to the lower node is to be transposed.
    std::vector<std::array<std::vector<int>, 2>> of_block(pattern_.column.size());
    for (std::size_t g = 0; g < body_.groups.size(); ++g) {
        const ElementGroup& group = body_.groups[g];
        const int n = group.nodes_per_element;
        for (int e = 0; e < group.size(); ++e) {
            const int* nodes = group.connectivity.data() + e * n;
            int pair = 0;
            for (int a = 0; a < n; ++a) {
                of_node[nodes[a]].push_back(slots_.force_slot(g, e, a));
                for (int b = a + 1; b < n; ++b, ++pair) {
                    const auto [low, high] = std::minmax(nodes[a], nodes[b]);
                    of_block[pattern_.find(low, high)][nodes[a] > nodes[b]].push_back(
                        slots_.block_slot(g, e, pair));
                }
            }
        }
    }
    force_begin_.assign(1, 0);
    for (const auto& slots : of_node) {
        force_slot_.insert(force_slot_.end(), slots.begin(), slots.end());
        force_begin_.push_back(static_cast<int>(force_slot_.size()));
    }
    block_begin_.assign(1, 0);
    for (const auto& slots : of_block)
        for (const auto& side : slots) {
            block_slot_.insert(block_slot_.end(), side.begin(), side.end());
            block_begin_.push_back(static_cast<int>(block_slot_.size()));
        }
}

void Assembly::gather_forces(std::span<Vec3> forces_un) const {
    parallel_blocks(forces_un.size(), row_block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            Vec3 sum = Vec3::Zero();
            for (int k = force_begin_[i]; k < force_begin_[i + 1]; ++k)
                sum += slots_.force(force_slot_[k]);
            forces_un[i] = sum;
        }
    });
}

void Assembly::gather_stiffness(double factor, BlockMatrix& matrix) const {
    if (matrix.column.size() != pattern_.column.size()) matrix = pattern_;
    const std::size_t rows = pattern_.rows();
    parallel_blocks(rows, row_block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            for (int k = pattern_.diagonal[i] + 1; k < pattern_.row_begin[i + 1]; ++k) {
                double sum[9] = {}, turned[9] = {};
                const int* begin_slot = &block_begin_[2 * static_cast<std::size_t>(k)];
                for (int s = begin_slot[0]; s < begin_slot[1]; ++s)
                    slots_.add_block(block_slot_[s], sum);
                for (int s = begin_slot[1]; s < begin_slot[2]; ++s)
                    slots_.add_block(block_slot_[s], turned);
                // Slots are row-major, the matrix is column-major.
                double* upper = matrix.block[k].data();
                double* lower = matrix.block[mirror_[k]].data();
                for (int r = 0; r < 3; ++r)
                    for (int c = 0; c < 3; ++c) {
                        const double entry = factor * (sum[3 * r + c] + turned[3 * c + r]);
                        lower[3 * r + c] = entry;
                        upper[3 * c + r] = entry;
                    }
            }
    });
    parallel_blocks(rows, row_block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            Mat3 sum = Mat3::Zero();
            const int diagonal = pattern_.diagonal[i];
            for (int k = pattern_.row_begin[i]; k < pattern_.row_begin[i + 1]; ++k)
                if (k != diagonal) sum += matrix.block[k];
            matrix.block[diagonal] = -0.5 * (sum + sum.transpose());
        }
    });
}

}  // namespace hepatica
