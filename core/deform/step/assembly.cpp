// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/step/assembly.h"

#include <algorithm>
#include <array>

#include "core/base/parallel.h"

namespace hepatica {
namespace {

constexpr std::size_t row_block = 256;

}  // namespace

Assembly::Assembly(const Body& body, small::Tangent tangent) : body_(body), slots_(body, tangent) {
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

// Sorts (entry, place) by entry; places of one entry keep their order.
Assembly::Contributions Assembly::by_entry(std::size_t entries,
                                           const std::vector<std::array<int, 2>>& pairs) {
    Contributions lists;
    lists.begin.assign(entries + 1, 0);
    for (const auto& [entry, place] : pairs) ++lists.begin[entry + 1];
    for (std::size_t k = 0; k < entries; ++k) lists.begin[k + 1] += lists.begin[k];
    lists.place.resize(pairs.size());
    std::vector<int> next = lists.begin;
    for (const auto& [entry, place] : pairs) lists.place[next[entry]++] = place;
    return lists;
}

void Assembly::build_gather_lists() {
    std::vector<std::array<int, 2>> forces, factors, blocks, transposed;
    for (std::size_t g = 0; g < body_.groups.size(); ++g) {
        const ElementGroup& group = body_.groups[g];
        const int n = group.nodes_per_element;
        for (int e = 0; e < group.size(); ++e) {
            const int* nodes = group.connectivity.data() + static_cast<std::ptrdiff_t>(e) * n;
            const int first = slots_.force_slot(g, e);
            for (int a = 0, pair = 0; a < n; ++a) {
                forces.push_back({nodes[a], first + a});
                for (int b = a + 1; b < n; ++b, ++pair) {
                    const bool turned = nodes[a] > nodes[b];
                    const int low = turned ? b : a, high = turned ? a : b;
                    const int k = pattern_.find(nodes[low], nodes[high]);
                    if (!slots_.in_factors(g)) {
                        (turned ? transposed : blocks)
                            .push_back({k, slots_.block_slot(g, e, pair)});
                        continue;
                    }
                    factors.push_back({k, first + low});
                    factors.push_back({k, first + high});
                }
            }
        }
    }
    forces_ = by_entry(static_cast<std::size_t>(body_.node_count()), forces);
    factors_ = by_entry(pattern_.column.size(), factors);
    blocks_ = by_entry(pattern_.column.size(), blocks);
    transposed_ = by_entry(pattern_.column.size(), transposed);
}

void Assembly::gather_forces(std::span<Vec3> forces_un) const {
    parallel_blocks(forces_un.size(), row_block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            Wide sum(0.0);
            for (int k = forces_.begin[i]; k < forces_.begin[i + 1]; ++k)
                sum += slots_.force()[forces_.place[k]];
            forces_un[i] = Vec3(sum[0], sum[1], sum[2]);
        }
    });
}

// Row-major, as the elements have it.
small::Matrix3<double> Assembly::upper_block(int k) const {
    const Wide* turned = slots_.turned_gradient();
    Wide column[3] = {0.0, 0.0, 0.0};  // of S, see evaluate_turned_gradients
    for (int s = factors_.begin[k]; s < factors_.begin[k + 1]; s += 2) {
        const Wide &a = turned[factors_.place[s]], &b = turned[factors_.place[s + 1]];
        for (int j = 0; j < 3; ++j) column[j] += Wide(a[j]) * b;
    }
    const double ratio = slots_.lambda_over_mu();
    const double trace = column[0][0] + column[1][1] + column[2][2];
    small::Matrix3<double> sum;
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) sum(i, j) = column[j][i] + ratio * column[i][j];
        sum(i, i) += trace;
    }
    for (int s = blocks_.begin[k]; s < blocks_.begin[k + 1]; ++s)
        sum = sum + slots_.block(blocks_.place[s]);
    for (int s = transposed_.begin[k]; s < transposed_.begin[k + 1]; ++s)
        sum = sum + transpose(slots_.block(transposed_.place[s]));
    return sum;
}

void Assembly::gather_stiffness(double factor, BlockMatrix& matrix) const {
    if (matrix.column.size() != pattern_.column.size()) matrix = pattern_;
    const std::size_t rows = pattern_.rows();
    parallel_blocks(rows, row_block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            for (int k = pattern_.diagonal[i] + 1; k < pattern_.row_begin[i + 1]; ++k) {
                const small::Matrix3<double> sum = upper_block(k);
                double* upper = matrix.block[k].data();  // column-major
                double* lower = matrix.block[mirror_[k]].data();
                for (int r = 0; r < 3; ++r)
                    for (int c = 0; c < 3; ++c) {
                        const double entry = factor * sum(r, c);
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
