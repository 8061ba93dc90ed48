// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/solvers/tree_cholesky.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <type_traits>
#include <utility>

#include "core/base/large_vector.h"
#include "core/base/parallel.h"
#include "core/deform/solvers/dense_front.h"

namespace hepatica {

namespace {

template <class T>
constexpr PivotRule pivot_rule =
    std::is_same_v<T, double> ? PivotRule{1e-14, true} : PivotRule{1e-6, false};

// Calls visit(s) for every supernode, children before parents; chains of a stage run in parallel.
template <class Visit>
void climb(const EliminationTree& tree, const Visit& visit) {
    for (const auto& stage : tree.stages) {
        parallel_blocks(stage.size(), 1, [&](std::size_t begin, std::size_t) {
            for (int k = stage[begin].begin; k < stage[begin].end; ++k) {
                visit(tree.chain_supernodes[k]);
            }
        });
    }
}

// As climb(), but parents before children.
template <class Visit>
void descend(const EliminationTree& tree, const Visit& visit) {
    for (std::size_t level = tree.stages.size(); level-- > 0;) {
        const auto& stage = tree.stages[level];
        parallel_blocks(stage.size(), 1, [&](std::size_t begin, std::size_t) {
            for (int k = stage[begin].end; k-- > stage[begin].begin;) {
                visit(tree.chain_supernodes[k]);
            }
        });
    }
}

// Reserves some more than is needed, because a body that tears will need it: reserved memory costs
// nothing until it is used, while new memory costs more than what is written there.
template <class T>
void make_room(std::vector<T>& values, std::size_t size) {
    if (size > values.capacity()) {
        std::vector<T>().swap(values);
        reserve_large(values, size + size / 8);
    }
    values.resize(size);
}

// Clears what a front may use of `columns` columns: from the packet that holds the diagonal.
template <class T>
void clear_lower(T* front, std::ptrdiff_t stride, int columns) {
    for (int c = 0; c < columns; ++c) {
        const int top = c / front_alignment<T> * front_alignment<T>;
        std::fill(front + c * stride + top, front + (c + 1) * stride, T(0));
    }
}

// Rows are read in the order of elimination, which no processor foresees: each is asked for while
// the ones before it are copied.
constexpr std::size_t rows_ahead = 2;

void fetch_row(const BlockMatrix& matrix, int i) {
    constexpr int cache_line = 64;
    const auto* first = reinterpret_cast<const char*>(matrix.block.data() + matrix.row_begin[i]);
    const auto* last = reinterpret_cast<const char*>(matrix.block.data() + matrix.row_begin[i + 1]);
    for (; first < last; first += cache_line) __builtin_prefetch(first);
}

}  // namespace

template <class T>
void TreeFactor<T>::lay_out_fronts() {
    for (auto* begins : {&panel_begin_, &remainder_begin_, &side_begin_}) begins->clear();
    std::size_t panel = 0, remainder = 0, side = 0;
    for (const Supernode& own : tree_.supernodes) {
        panel_begin_.push_back(panel);
        remainder_begin_.push_back(remainder);
        side_begin_.push_back(side);
        const std::size_t columns = 3 * static_cast<std::size_t>(own.count);
        const std::size_t rows = 3 * static_cast<std::size_t>(own.rest());
        const auto stride = static_cast<std::size_t>(padded<T>(static_cast<int>(columns + rows)));
        panel += stride * columns + front_alignment<T>;
        remainder +=
            static_cast<std::size_t>(padded<T>(static_cast<int>(rows))) * rows + front_alignment<T>;
        side += stride;
    }
    make_room(panels_, panel);
    make_room(remainders_, remainder);
    make_room(sides_, side);
    dropped_.assign(tree_.supernodes.size(), 0);
    dirty_.assign(tree_.supernodes.size(), 0);
}

template <class T>
void TreeFactor<T>::plan(const BlockMatrix& pattern, EliminationTree tree) {
    tree_ = std::move(tree);
    lay_out_fronts();
    block_row_.assign(pattern.column.size(), -1);
    for (int j = 0; j < static_cast<int>(tree_.vertex_at.size()); ++j) {
        const Supernode& own = tree_.supernodes[tree_.supernode_of[j]];
        const int v = tree_.vertex_at[j];
        for (int k = pattern.row_begin[v]; k < pattern.row_begin[v + 1]; ++k) {
            const int i = tree_.position_of[pattern.column[k]];
            if (i < j) continue;
            if (i < own.first + own.count) {
                block_row_[k] = i - own.first;
                continue;
            }
            const auto first = tree_.rows.begin() + own.rows_begin;
            const auto found = std::lower_bound(first, tree_.rows.begin() + own.rows_end, i);
            block_row_[k] = own.count + static_cast<int>(found - first);
        }
    }
}

template <class T>
std::size_t TreeFactor<T>::bytes() const {
    return sizeof(T) * (panels_.size() + remainders_.size() + sides_.size()) +
           sizeof(int) * (block_row_.size() + 2 * tree_.rows.size() + 3 * dropped_.size());
}

template <class T>
void TreeFactor<T>::factor_supernode(const BlockMatrix& matrix, int s,
                                     const std::stop_token& stop) {
    const Supernode& own = tree_.supernodes[s];
    const int columns = 3 * own.count, rest = 3 * own.rest();
    const std::ptrdiff_t stride = padded<T>(columns + rest), rest_stride = padded<T>(rest);
    T* panel = panels_.data() + panel_begin_[s];
    T* remainder = remainders_.data() + remainder_begin_[s];
    clear_lower(panel, stride, columns);
    clear_lower(remainder, rest_stride, rest);
    const auto last = tree_.vertex_at.size() - 1;
    for (int c = 0; c < own.count; ++c) {
        const int v = tree_.vertex_at[own.first + c];
        fetch_row(matrix, tree_.vertex_at[std::min<std::size_t>(own.first + c + rows_ahead, last)]);
        for (int k = matrix.row_begin[v]; k < matrix.row_begin[v + 1]; ++k) {
            if (block_row_[k] < 0) continue;
            T* target = panel + 3 * c * stride + 3 * block_row_[k];
            const Mat3& block = matrix.block[k];
            for (int a = 0; a < 3; ++a) {
                for (int b = 0; b < 3; ++b) target[a * stride + b] = static_cast<T>(block(a, b));
            }
        }
    }
    for (int k = own.children_begin; k < own.children_end; ++k) {
        const Supernode& child = tree_.supernodes[tree_.children[k]];
        const T* passed = remainders_.data() + remainder_begin_[tree_.children[k]];
        const int count = child.rest();
        const std::ptrdiff_t passed_stride = padded<T>(3 * count);
        const int* place = tree_.place_in_parent.data() + child.rows_begin;
        for (int c = 0; c < count; ++c) {
            const bool eliminated_here = place[c] < own.count;
            T* base = eliminated_here ? panel + 3 * place[c] * stride
                                      : remainder + 3 * (place[c] - own.count) * rest_stride;
            const std::ptrdiff_t base_stride = eliminated_here ? stride : rest_stride;
            const int shift = eliminated_here ? 0 : own.count;
            for (int a = 0; a < 3; ++a) {
                const T* source = passed + (3 * c + a) * passed_stride;
                T* target = base + a * base_stride;
                for (int r = c; r < count; ++r) {
                    T* to = target + 3 * (place[r] - shift);
                    to[0] += source[3 * r];
                    to[1] += source[3 * r + 1];
                    to[2] += source[3 * r + 2];
                }
            }
        }
    }
    dropped_[s] = factor_front(panel, remainder, columns, rest, pivot_rule<T>, stop);
}

template <class T>
void TreeFactor<T>::factor(const BlockMatrix& matrix, const std::stop_token& stop) {
    climb(tree_, [&](int s) { factor_supernode(matrix, s, stop); });
    eliminated_ = static_cast<int>(tree_.supernodes.size());
}

template <class T>
void TreeFactor<T>::refactor(const BlockMatrix& matrix, std::span<const int> changed_vertices,
                             const std::stop_token& stop) {
    std::fill(dirty_.begin(), dirty_.end(), 0);
    for (const int v : changed_vertices) dirty_[tree_.supernode_of[tree_.position_of[v]]] = 1;
    climb(tree_, [&](int s) {
        const Supernode& own = tree_.supernodes[s];
        for (int k = own.children_begin; k < own.children_end; ++k) {
            if (dirty_[tree_.children[k]]) dirty_[s] = 1;
        }
        if (dirty_[s]) factor_supernode(matrix, s, stop);
    });
    eliminated_ = static_cast<int>(std::count(dirty_.begin(), dirty_.end(), 1));
}

template <class T>
int TreeFactor<T>::dropped_pivots() const {
    return std::accumulate(dropped_.begin(), dropped_.end(), 0);
}

// Adds what a front passes on of its right-hand side to that of its parent.
template <class T>
void TreeFactor<T>::pass_up(const Supernode& child, const T* passed, T* parent_side) const {
    for (int r = 0; r < child.rest(); ++r) {
        T* to = parent_side + 3 * tree_.place_in_parent[child.rows_begin + r];
        for (int a = 0; a < 3; ++a) to[a] += passed[3 * r + a];
    }
}

template <class T>
void TreeFactor<T>::forward(std::span<const Vec3> b) {
    using Vector = Eigen::Matrix<T, 3, 1>;
    climb(tree_, [&](int s) {
        const Supernode& own = tree_.supernodes[s];
        const int columns = 3 * own.count, rest = 3 * own.rest();
        T* side = sides_.data() + side_begin_[s];
        for (int c = 0; c < own.count; ++c) {
            Eigen::Map<Vector>(side + 3 * c) = b[tree_.vertex_at[own.first + c]].template cast<T>();
        }
        std::fill(side + columns, side + padded<T>(columns + rest), T(0));
        for (int k = own.children_begin; k < own.children_end; ++k) {
            const Supernode& child = tree_.supernodes[tree_.children[k]];
            pass_up(child, sides_.data() + side_begin_[tree_.children[k]] + 3 * child.count, side);
        }
        forward_front(panels_.data() + panel_begin_[s], columns, rest, side);
    });
}

template <class T>
double TreeFactor<T>::inverse_form(std::span<const Vec3> b) {
    forward(b);
    return parallel_sum(tree_.supernodes.size(), 64, [&](std::size_t begin, std::size_t end) {
        double sum = 0.0;
        for (std::size_t s = begin; s < end; ++s) {
            const T* side = sides_.data() + side_begin_[s];
            for (int i = 0; i < 3 * tree_.supernodes[s].count; ++i)
                sum += static_cast<double>(side[i]) * static_cast<double>(side[i]);
        }
        return sum;
    });
}

template <class T>
void TreeFactor<T>::solve(std::span<const Vec3> b, std::span<Vec3> x) {
    using Vector = Eigen::Matrix<T, 3, 1>;
    forward(b);
    descend(tree_, [&](int s) {
        const Supernode& own = tree_.supernodes[s];
        T* side = sides_.data() + side_begin_[s];
        if (own.parent >= 0) {
            const T* parent_side = sides_.data() + side_begin_[own.parent];
            for (int r = 0; r < own.rest(); ++r) {
                const T* from = parent_side + 3 * tree_.place_in_parent[own.rows_begin + r];
                for (int a = 0; a < 3; ++a) side[3 * (own.count + r) + a] = from[a];
            }
        }
        backward_front(panels_.data() + panel_begin_[s], 3 * own.count, 3 * own.rest(), side);
        for (int c = 0; c < own.count; ++c) {
            x[tree_.vertex_at[own.first + c]] =
                Eigen::Map<const Vector>(side + 3 * c).template cast<double>();
        }
    });
}

// With A = L L^T the block is Y^T Y with Y = L^-1 J^T. The backward substitution is not needed, and
// Y is zero in all fronts that are not between a loaded vertex and the root.
template <class T>
Eigen::MatrixXd TreeFactor<T>::inverse_block(std::span<const SparseLoad> loads) const {
    std::vector<char> on_path(tree_.supernodes.size(), 0);
    for (const SparseLoad& load : loads)
        for (const int v : load.vertices) on_path[tree_.supernode_of[tree_.position_of[v]]] = 1;
    std::vector<int> path;
    std::vector<std::size_t> head_of(on_path.size()), side_of(on_path.size());
    std::size_t heads = 0, sides = 0;
    for (std::size_t s = 0; s < on_path.size(); ++s) {
        if (!on_path[s]) continue;
        const Supernode& own = tree_.supernodes[s];
        path.push_back(static_cast<int>(s));
        head_of[s] = std::exchange(heads, heads + 3 * static_cast<std::size_t>(own.count));
        side_of[s] = std::exchange(sides, sides + padded<T>(3 * (own.count + own.rest())));
        if (own.parent >= 0) on_path[own.parent] = 1;
    }
    Eigen::Matrix<T, Eigen::Dynamic, Eigen::Dynamic> y =
        Eigen::Matrix<T, Eigen::Dynamic, Eigen::Dynamic>::Zero(
            static_cast<Eigen::Index>(heads), static_cast<Eigen::Index>(loads.size()));
    parallel_blocks(loads.size(), 1, [&](std::size_t j, std::size_t) {
        std::vector<T> side(sides, T(0));
        std::vector<char> reached(on_path.size(), 0);
        for (std::size_t i = 0; i < loads[j].vertices.size(); ++i) {
            const int at = tree_.position_of[loads[j].vertices[i]], s = tree_.supernode_of[at];
            T* to = side.data() + side_of[s] + 3 * (at - tree_.supernodes[s].first);
            for (int a = 0; a < 3; ++a) to[a] += static_cast<T>(loads[j].forces[i][a]);
            reached[s] = 1;
        }
        for (const int s : path) {
            const Supernode& own = tree_.supernodes[s];
            if (!reached[s]) continue;
            T* own_side = side.data() + side_of[s];
            forward_front(panels_.data() + panel_begin_[s], 3 * own.count, 3 * own.rest(),
                          own_side);
            std::copy_n(own_side, 3 * own.count,
                        y.col(static_cast<Eigen::Index>(j)).data() + head_of[s]);
            if (own.parent < 0) continue;
            reached[own.parent] = 1;
            pass_up(own, own_side + 3 * own.count, side.data() + side_of[own.parent]);
        }
    });
    const Eigen::MatrixXd exact = y.template cast<double>();
    return exact.transpose() * exact;
}

template class TreeFactor<double>;
template class TreeFactor<float>;

}  // namespace hepatica
