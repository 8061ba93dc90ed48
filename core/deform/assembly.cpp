// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/assembly.h"

#include <algorithm>
#include <array>

#include "core/base/parallel.h"
#include "core/deform/elements/element_dispatch.h"

namespace hepatica {
namespace {

constexpr std::size_t element_block = 128;
constexpr std::size_t row_block = 256;

using small::Tangent;

// Slots hold the block of the lower node's row: what an element wrote the other way is transposed.
void turn_blocks(const int* nodes, int count, small::Matrix3<double>* block) {
    for (int a = 0; a < count; ++a)
        for (int b = a + 1; b < count; ++b, ++block)
            if (nodes[a] > nodes[b]) *block = transpose(*block);
}

}  // namespace

Assembly::Assembly(const Body& body) : body_(body) {
    std::size_t forces = 0, blocks = 0;
    for (const ElementGroup& group : body.groups) {
        slots_.push_back({forces, blocks});
        forces += group.connectivity.size();
        blocks += static_cast<std::size_t>(group.size()) * group.pairs();
    }
    element_force_.resize(forces);
    element_block_.resize(blocks);
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
    std::vector<std::vector<int>> of_block(pattern_.column.size());
    for (std::size_t g = 0; g < body_.groups.size(); ++g) {
        const ElementGroup& group = body_.groups[g];
        const int n = group.nodes_per_element;
        for (int e = 0; e < group.size(); ++e) {
            const int* nodes = group.connectivity.data() + e * n;
            int slot = static_cast<int>(slots_[g].first_block) + e * group.pairs();
            for (int a = 0; a < n; ++a) {
                of_node[nodes[a]].push_back(static_cast<int>(slots_[g].first_force) + e * n + a);
                for (int b = a + 1; b < n; ++b, ++slot) {
                    const auto [low, high] = std::minmax(nodes[a], nodes[b]);
                    of_block[pattern_.find(low, high)].push_back(slot);
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
    for (const auto& slots : of_block) {
        block_slot_.insert(block_slot_.end(), slots.begin(), slots.end());
        block_begin_.push_back(static_cast<int>(block_slot_.size()));
    }
}

double Assembly::evaluate(std::span<const Vec3> positions_mm, Tangent tangent) {
    double energy = 0.0;
    for (std::size_t g = 0; g < body_.groups.size(); ++g) {
        const ElementGroup& group = body_.groups[g];
        const int n = group.nodes_per_element, pairs = group.pairs();
        energy +=
            parallel_sum(group.size(), element_block, [&](std::size_t begin, std::size_t end) {
                double sum = 0.0;
                for (std::size_t i = begin; i < end; ++i) {
                    const int e = static_cast<int>(i);
                    auto* force = element_force_.data() + slots_[g].first_force + i * n;
                    auto* blocks = element_block_.data() + slots_[g].first_block + i * pairs;
                    if (tangent == Tangent::none)
                        sum += evaluate_element<Tangent::none>(group, body_.model, e, positions_mm,
                                                               force, nullptr);
                    else if (tangent == Tangent::rotated)
                        sum += evaluate_element<Tangent::rotated>(group, body_.model, e,
                                                                  positions_mm, force, blocks);
                    else
                        sum += evaluate_element<Tangent::projected>(group, body_.model, e,
                                                                    positions_mm, force, blocks);
                    if (tangent != Tangent::none)
                        turn_blocks(group.connectivity.data() + i * n, n, blocks);
                }
                return sum;
            });
    }
    return energy;
}

double Assembly::energy(std::span<const Vec3> positions_mm) const {
    double energy = 0.0;
    for (const ElementGroup& group : body_.groups)
        energy +=
            parallel_sum(group.size(), element_block, [&](std::size_t begin, std::size_t end) {
                double sum = 0.0;
                for (std::size_t i = begin; i < end; ++i)
                    sum += evaluate_element<Tangent::none>(group, body_.model, static_cast<int>(i),
                                                           positions_mm, nullptr, nullptr);
                return sum;
            });
    return energy;
}

void Assembly::gather_forces(std::span<Vec3> forces_un) const {
    parallel_blocks(forces_un.size(), row_block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            Vec3 sum = Vec3::Zero();
            for (int k = force_begin_[i]; k < force_begin_[i + 1]; ++k)
                sum += small::to_eigen(element_force_[force_slot_[k]]);
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
                double sum[9] = {};
                for (int s = block_begin_[k]; s < block_begin_[k + 1]; ++s) {
                    const double* block = element_block_[block_slot_[s]].m[0];
                    for (int n = 0; n < 9; ++n) sum[n] += block[n];
                }
                // The slot is row-major, the matrix column-major.
                double* upper = matrix.block[k].data();
                double* lower = matrix.block[mirror_[k]].data();
                for (int n = 0; n < 9; ++n) lower[n] = factor * sum[n];
                for (int r = 0; r < 3; ++r)
                    for (int c = 0; c < 3; ++c) upper[3 * c + r] = lower[3 * r + c];
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

double Assembly::quadratic_form(std::span<const Vec3> d) const {
    double total = 0.0;
    for (std::size_t g = 0; g < body_.groups.size(); ++g) {
        const ElementGroup& group = body_.groups[g];
        const int n = group.nodes_per_element, pairs = group.pairs();
        total += parallel_sum(group.size(), element_block, [&](std::size_t begin, std::size_t end) {
            double sum = 0.0;
            for (std::size_t e = begin; e < end; ++e) {
                const int* nodes = group.connectivity.data() + e * n;
                const auto* block = element_block_.data() + slots_[g].first_block + e * pairs;
                small::Vector3<double> u[10];  // relative to the first node
                for (int a = 0; a < n; ++a)
                    u[a] = small::from_eigen(Vec3(d[nodes[a]] - d[nodes[0]]));
                for (int a = 0; a < n; ++a)
                    for (int b = a + 1; b < n; ++b, ++block) {
                        const bool ascending = nodes[a] < nodes[b];
                        const auto& low = ascending ? u[a] : u[b];
                        const auto& high = ascending ? u[b] : u[a];
                        sum += 2.0 * small::dot(low, *block * high) -
                               small::dot(low, *block * low) - small::dot(high, *block * high);
                    }
            }
            return sum;
        });
    }
    return total;
}

}  // namespace hepatica
