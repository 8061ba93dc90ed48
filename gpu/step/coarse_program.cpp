// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/step/coarse_program.h"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <array>

#include "gpu/kernels/coarse_kernels.h"

namespace hepatica::gpu {
namespace {

constexpr int node_size = 3 * coarse_vectors;
using Dense = Eigen::Matrix<double, node_size, node_size>;
using Columns = Eigen::SparseMatrix<double>;
using Rows = Eigen::SparseMatrix<double, Eigen::RowMajor>;

std::vector<std::vector<int>> neighbours_of(const CoarseSkeleton& skeleton) {
    std::vector<std::vector<int>> neighbours(static_cast<std::size_t>(skeleton.size()));
    for (int i = 0; i < skeleton.size(); ++i)
        if (const int parent = skeleton.parent[i]; parent >= 0) {
            neighbours[i].push_back(parent);
            neighbours[parent].push_back(i);
        }
    return neighbours;
}

// Cuts a forest in halves, again and again. Nodes of two branches that meet at a cut share
// elements, so that a cut takes two neighbouring nodes.
class Bisection {
  public:
    explicit Bisection(const CoarseSkeleton& skeleton)
        : neighbours_(neighbours_of(skeleton)),
          gone_(neighbours_.size(), 0),
          above_(neighbours_.size(), -1),
          size_(neighbours_.size(), 0) {}

    std::vector<int> order() {
        std::vector<int> waiting, removed;
        for (int i = static_cast<int>(gone_.size()); i-- > 0;) waiting.push_back(i);
        while (!waiting.empty()) {
            const int start = waiting.back();
            waiting.pop_back();
            if (gone_[start] != 0) continue;
            for (const int cut : cut_of(start)) {
                if (gone_[cut] != 0) continue;
                gone_[cut] = 1;
                removed.push_back(cut);
                waiting.insert(waiting.end(), neighbours_[cut].begin(), neighbours_[cut].end());
            }
        }
        std::ranges::reverse(removed);
        return removed;
    }

  private:
    // The centroid of what is left around `start`, and its neighbour in the largest part.
    std::array<int, 2> cut_of(int start) {
        std::vector<int> reached{start};
        above_[start] = -1;
        for (std::size_t k = 0; k < reached.size(); ++k)
            for (const int j : neighbours_[reached[k]])
                if (gone_[j] == 0 && j != above_[reached[k]]) {
                    above_[j] = reached[k];
                    reached.push_back(j);
                }
        const int whole = static_cast<int>(reached.size());
        for (const int i : reached) size_[i] = 1;
        for (std::size_t k = reached.size(); k-- > 1;)
            size_[above_[reached[k]]] += size_[reached[k]];
        for (int at = start;;) {
            const int below = largest_below(at);
            if (below >= 0 && 2 * size_[below] > whole) {
                at = below;
                continue;
            }
            const bool upward = above_[at] >= 0 && (below < 0 || whole - size_[at] > size_[below]);
            return {at, upward ? above_[at] : (below >= 0 ? below : at)};
        }
    }
    int largest_below(int i) const {
        int largest = -1;
        for (const int j : neighbours_[i])
            if (gone_[j] == 0 && j != above_[i] && (largest < 0 || size_[j] > size_[largest]))
                largest = j;
        return largest;
    }

    std::vector<std::vector<int>> neighbours_;
    std::vector<char> gone_;
    std::vector<int> above_, size_;
};

// Lower triangle, nodes by their place in the order.
Columns in_order(const BlockMatrix& coarse, const std::vector<int>& order) {
    std::vector<int> place(order.size());
    for (std::size_t p = 0; p < order.size(); ++p) place[order[p]] = static_cast<int>(p);
    const auto position = [&](int vector, int c) {
        return node_size * place[vector / coarse_vectors] + 3 * (vector % coarse_vectors) + c;
    };
    std::vector<Eigen::Triplet<double>> entries;
    for (int i = 0; i < coarse.rows(); ++i)
        for (int k = coarse.row_begin[i]; k < coarse.row_begin[i + 1]; ++k)
            for (int r = 0; r < 3; ++r)
                for (int c = 0; c < 3; ++c) {
                    const int row = position(i, r), column = position(coarse.column[k], c);
                    if (row >= column) entries.emplace_back(row, column, coarse.block[k](r, c));
                }
    Columns matrix(3 * coarse.rows(), 3 * coarse.rows());
    matrix.setFromTriplets(entries.begin(), entries.end());
    for (int i = 0; i < matrix.rows(); ++i)
        if (double& own = matrix.coeffRef(i, i); !(own > 0.0)) own = 1.0;
    return matrix;
}

Columns factor_of(Columns matrix) {
    Eigen::SimplicialLLT<Columns, Eigen::Lower, Eigen::NaturalOrdering<int>> factor;
    const Eigen::VectorXd diagonal = matrix.diagonal();
    for (double raise = 1e-9;; raise *= 100.0) {
        for (int i = 0; i < matrix.rows(); ++i) matrix.coeffRef(i, i) = (1.0 + raise) * diagonal[i];
        factor.compute(matrix);
        if (factor.info() == Eigen::Success || raise > 1.0) break;
    }
    return factor.matrixL();
}

Dense inverse_of_own(const Columns& l, int node) {
    const Dense own =
        Eigen::MatrixXd(l.block(node_size * node, node_size * node, node_size, node_size));
    Dense inverse = Dense::Identity();
    own.triangularView<Eigen::Lower>().solveInPlace(inverse);
    return inverse;
}

class Writer {
  public:
    Writer(const BlockMatrix& coarse, const std::vector<int>& order)
        : order_(order), l_(factor_of(in_order(coarse, order))), rows_(l_) {
        const int n = static_cast<int>(l_.rows());
        program_.solution = 3 * n;
        program_.values = 4 * n;
        load_ = 0, work_ = n, halfway_ = 2 * n;
        find_levels();
        for (int p = 0; p < nodes(); ++p) inverse_.push_back(inverse_of_own(l_, p));
    }

    CoarseProgram write() {
        for (const std::vector<int>& level : levels_) {
            for_rows(level, [&](int i) { forward_load(i); });
            for_rows(level, [&](int i) { forward_own(i); });
        }
        for (std::size_t k = levels_.size(); k-- > 0;) {
            for_rows(levels_[k], [&](int i) { backward_load(i); });
            for_rows(levels_[k], [&](int i) { backward_own(i); });
        }
        return std::move(program_);
    }

  private:
    int nodes() const { return static_cast<int>(order_.size()); }
    // Of an unknown in the matrix' own numbering.
    int outside(int i) const { return node_size * order_[i / node_size] + i % node_size; }

    // A node stands one level above the highest that it hears from.
    void find_levels() {
        std::vector<int> level(order_.size(), 0);
        for (int i = 0; i < rows_.rows(); ++i)
            for (Rows::InnerIterator entry(rows_, i); entry; ++entry)
                if (const auto from = static_cast<int>(entry.col()) / node_size;
                    from < i / node_size)
                    level[i / node_size] = std::max(level[i / node_size], level[from] + 1);
        for (int p = 0; p < nodes(); ++p) {
            levels_.resize(std::max(levels_.size(), static_cast<std::size_t>(level[p]) + 1));
            levels_[level[p]].push_back(p);
        }
    }

    template <class Write>
    void for_rows(const std::vector<int>& level, const Write& write) {
        for (const int p : level)
            for (int i = node_size * p; i < node_size * (p + 1); ++i) {
                write(i);
                program_.begin.push_back(static_cast<int>(program_.source.size()));
            }
        program_.stage_begin.push_back(static_cast<int>(program_.target.size()));
    }
    void term(int source, double factor) {
        program_.source.push_back(source);
        program_.factor.push_back(factor);
    }

    // g = b - L y of lower levels
    void forward_load(int i) {
        program_.target.push_back(work_ + i);
        term(load_ + outside(i), 1.0);
        for (Rows::InnerIterator entry(rows_, i); entry; ++entry)
            if (const auto k = static_cast<int>(entry.col()); k / node_size < i / node_size)
                term(halfway_ + k, -entry.value());
    }
    // y = L_own^-1 g
    void forward_own(int i) {
        program_.target.push_back(halfway_ + i);
        const int first = i / node_size * node_size;
        for (int k = first; k <= i; ++k)
            term(work_ + k, inverse_[i / node_size](i - first, k - first));
    }
    // g = y - L^T x of higher levels
    void backward_load(int i) {
        program_.target.push_back(work_ + i);
        term(halfway_ + i, 1.0);
        for (Columns::InnerIterator entry(l_, i); entry; ++entry)
            if (const auto k = static_cast<int>(entry.row()); k / node_size > i / node_size)
                term(program_.solution + outside(k), -entry.value());
    }
    // x = L_own^-T g
    void backward_own(int i) {
        program_.target.push_back(program_.solution + outside(i));
        const int first = i / node_size * node_size;
        for (int k = i; k < first + node_size; ++k)
            term(work_ + k, inverse_[i / node_size](k - first, i - first));
    }

    const std::vector<int>& order_;
    Columns l_;
    Rows rows_;
    int load_ = 0, work_ = 0, halfway_ = 0;
    std::vector<std::vector<int>> levels_;
    std::vector<Dense> inverse_;
    CoarseProgram program_;
};

}  // namespace

std::vector<int> bisecting_order(const CoarseSkeleton& skeleton) {
    return Bisection(skeleton).order();
}

CoarseProgram program_of(const BlockMatrix& coarse, const std::vector<int>& order) {
    return Writer(coarse, order).write();
}

}  // namespace hepatica::gpu
