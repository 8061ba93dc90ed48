// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/solvers/affine_coarse_space.h"

#include <algorithm>
#include <map>
#include <utility>

#include "core/base/parallel.h"

namespace hepatica {

namespace {
constexpr std::size_t vertices_per_block = 1024;
constexpr int block_entries = 9;
}  // namespace

AffineCoarseSpace::AffineCoarseSpace(const CoarseSkeleton& skeleton, SkeletonBinding binding,
                                     const BlockMatrix& pattern)
    : node_count_(skeleton.size()), binding_(std::move(binding)), radii_mm_(skeleton.radii_mm) {
    std::map<std::array<int, 2>, std::vector<int>> members;
    for (std::size_t v = 0; v < binding_.nodes.size(); ++v) {
        members[binding_.nodes[v]].push_back(static_cast<int>(v));
    }
    groups_of_.resize(static_cast<std::size_t>(node_count_));
    for (auto& [nodes, vertices] : members) {
        for (std::size_t end = 0; end < (nodes[0] == nodes[1] ? 1u : 2u); ++end) {
            groups_of_[nodes[end]].push_back(static_cast<int>(groups_.size()));
        }
        groups_.push_back({nodes, std::move(vertices), {}});
    }
    slots_.resize(pattern.column.size());
    parallel_blocks(groups_.size(), 8, [&](std::size_t begin, std::size_t end) {
        for (std::size_t g = begin; g < end; ++g) find_columns(groups_[g], pattern);
    });
    modes_.resize(binding_.nodes.size());
    build_coarse_pattern();
}

void AffineCoarseSpace::find_columns(Group& group, const BlockMatrix& pattern) {
    std::vector<int>& columns = group.columns;
    for (const int v : group.vertices) {
        for (int k = pattern.row_begin[v]; k < pattern.row_begin[v + 1]; ++k) {
            const auto& nodes = binding_.nodes[pattern.column[k]];
            columns.insert(columns.end(), nodes.begin(), nodes.end());
        }
    }
    std::sort(columns.begin(), columns.end());
    columns.erase(std::unique(columns.begin(), columns.end()), columns.end());
    for (const int v : group.vertices) {
        for (int k = pattern.row_begin[v]; k < pattern.row_begin[v + 1]; ++k) {
            for (std::size_t side = 0; side < 2; ++side) {
                const int node = binding_.nodes[pattern.column[k]][side];
                slots_[k][side] = static_cast<std::uint16_t>(
                    std::lower_bound(columns.begin(), columns.end(), node) - columns.begin());
            }
        }
    }
}

void AffineCoarseSpace::build_coarse_pattern() {
    for (int node = 0; node < node_count_; ++node) {
        std::vector<int> columns{node};
        for (const int g : groups_of_[node]) {
            columns.insert(columns.end(), groups_[g].columns.begin(), groups_[g].columns.end());
        }
        std::sort(columns.begin(), columns.end());
        columns.erase(std::unique(columns.begin(), columns.end()), columns.end());
        for (int row = 0; row < vectors_per_node; ++row) {
            for (const int other : columns) {
                for (int k = 0; k < vectors_per_node; ++k) {
                    if (other == node && k == row) {
                        pattern_.diagonal.push_back(static_cast<int>(pattern_.column.size()));
                    }
                    pattern_.column.push_back(vectors_per_node * other + k);
                }
            }
            pattern_.row_begin.push_back(static_cast<int>(pattern_.column.size()));
        }
    }
    pattern_.block.assign(pattern_.column.size(), Mat3::Zero());
}

void AffineCoarseSpace::set_shape(std::span<const Vec3> positions_mm, std::span<const char> fixed) {
    // Any centre spans the same motions; the mean of the vertices keeps the modes well-conditioned.
    centres_mm_.assign(static_cast<std::size_t>(node_count_), Vec3::Zero());
    std::vector<double> weight(static_cast<std::size_t>(node_count_), 0.0);
    for (std::size_t v = 0; v < positions_mm.size(); ++v) {
        for (std::size_t end = 0; end < 2; ++end) {
            centres_mm_[binding_.nodes[v][end]] += binding_.weights[v][end] * positions_mm[v];
            weight[binding_.nodes[v][end]] += binding_.weights[v][end];
        }
    }
    for (std::size_t n = 0; n < centres_mm_.size(); ++n) {
        if (weight[n] > 0.0) centres_mm_[n] /= weight[n];
    }
    for (std::size_t v = 0; v < positions_mm.size(); ++v) {
        for (std::size_t end = 0; end < 2; ++end) {
            const int node = binding_.nodes[v][end];
            const Vec3 arm = (positions_mm[v] - centres_mm_[node]) / radii_mm_[node];
            const double factor = fixed[v] ? 0.0 : binding_.weights[v][end];
            modes_[v][end] = factor * Modes(1.0, arm.x(), arm.y(), arm.z());
        }
    }
}

void AffineCoarseSpace::restrict_to_nodes(std::span<const Vec3> fine,
                                          std::vector<Vec3>& coarse) const {
    using Sum = Eigen::Matrix<double, 4, 3>;
    std::vector<std::array<Sum, 2>> sums(groups_.size());
    parallel_blocks(groups_.size(), 16, [&](std::size_t begin, std::size_t end) {
        for (std::size_t g = begin; g < end; ++g) {
            sums[g].fill(Sum::Zero());
            for (const int v : groups_[g].vertices) {
                for (int a = 0; a < 3; ++a) {
                    sums[g][0].col(a) += fine[v][a] * modes_[v][0];
                    sums[g][1].col(a) += fine[v][a] * modes_[v][1];
                }
            }
        }
    });
    coarse.assign(static_cast<std::size_t>(vectors_per_node * node_count_), Vec3::Zero());
    for (std::size_t g = 0; g < groups_.size(); ++g) {
        for (std::size_t end = 0; end < 2; ++end) {
            const int base = vectors_per_node * groups_[g].nodes[end];
            for (int k = 0; k < vectors_per_node; ++k)
                coarse[base + k] += sums[g][end].row(k).transpose();
        }
    }
}

void AffineCoarseSpace::add_motion(std::span<const Vec3> coarse, std::span<Vec3> fine) const {
    parallel_blocks(fine.size(), vertices_per_block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t v = begin; v < end; ++v) {
            Vec3 sum = fine[v];
            for (std::size_t side = 0; side < 2; ++side) {
                const Vec3* motion = &coarse[vectors_per_node * binding_.nodes[v][side]];
                for (int k = 0; k < vectors_per_node; ++k) sum += modes_[v][side][k] * motion[k];
            }
            fine[v] = sum;
        }
    });
}

// Layout of `product`, outermost index first: end of the group, mode of that end, column node,
// entry of the 3x3 block, mode of the column node.
void AffineCoarseSpace::project_group(const BlockMatrix& matrix, const Group& group,
                                      std::vector<double>& product) const {
    const std::size_t columns = group.columns.size();
    const std::size_t row = columns * block_entries;
    product.assign(2 * vectors_per_node * row * vectors_per_node, 0.0);
    std::vector<Modes> reached(row);  // (A P) in the row of one vertex
    for (const int v : group.vertices) {
        std::fill(reached.begin(), reached.end(), Modes::Zero());
        for (int k = matrix.row_begin[v]; k < matrix.row_begin[v + 1]; ++k) {
            const int w = matrix.column[k];
            const double* block = matrix.block[k].data();
            for (std::size_t side = 0; side < 2; ++side) {
                Modes* target = &reached[static_cast<std::size_t>(slots_[k][side]) * block_entries];
                const Modes modes = modes_[w][side];
                for (int e = 0; e < block_entries; ++e) target[e] += block[e] * modes;
            }
        }
        for (std::size_t side = 0; side < 2; ++side) {
            for (std::size_t m = 0; m < vectors_per_node; ++m) {
                const double factor = modes_[v][side][static_cast<int>(m)];
                double* target =
                    product.data() + (side * vectors_per_node + m) * row * vectors_per_node;
                for (std::size_t e = 0; e < row; ++e) {
                    Eigen::Map<Modes>(target + e * vectors_per_node) += factor * reached[e];
                }
            }
        }
    }
}

void AffineCoarseSpace::project(const BlockMatrix& matrix, BlockMatrix& coarse) const {
    std::vector<std::vector<double>> products(groups_.size());
    parallel_blocks(groups_.size(), 4, [&](std::size_t begin, std::size_t end) {
        for (std::size_t g = begin; g < end; ++g) project_group(matrix, groups_[g], products[g]);
    });
    parallel_blocks(
        static_cast<std::size_t>(node_count_), 16, [&](std::size_t begin, std::size_t end) {
            for (std::size_t n = begin; n < end; ++n) {
                const int node = static_cast<int>(n);
                const int first_row = vectors_per_node * node;
                for (int k = coarse.row_begin[first_row];
                     k < coarse.row_begin[first_row + vectors_per_node]; ++k) {
                    coarse.block[k].setZero();
                }
                for (const int g : groups_of_[n]) {
                    const Group& group = groups_[g];
                    const std::size_t row = group.columns.size() * block_entries;
                    for (std::size_t side = 0; side < 2; ++side) {
                        if (group.nodes[side] != node) continue;
                        for (std::size_t c = 0; c < group.columns.size(); ++c) {
                            const int other = vectors_per_node * group.columns[c];
                            const int place = coarse.find(first_row, other);
                            const int width =
                                coarse.row_begin[first_row + 1] - coarse.row_begin[first_row];
                            for (int m = 0; m < vectors_per_node; ++m) {
                                const double* source =
                                    products[g].data() +
                                    ((side * vectors_per_node + static_cast<std::size_t>(m)) * row +
                                     c * block_entries) *
                                        vectors_per_node;
                                for (int l = 0; l < vectors_per_node; ++l) {
                                    double* target = coarse.block[place + m * width + l].data();
                                    for (int e = 0; e < block_entries; ++e) {
                                        target[e] += source[e * vectors_per_node + l];
                                    }
                                }
                            }
                        }
                    }
                }
            }
        });
}

}  // namespace hepatica
