// SPDX-License-Identifier: GPL-3.0-or-later
// Block factorisation N D N^T of the coarse matrix P^T A P by cuts of two nodes each (CoarsePlan),
// the inversion of N, and the solve. One block of threads eliminates a cut: blocks are dense and
// gathered by lists, and no two blocks of threads of a level write to the same place.
#pragma once

#include "gpu/kernels/planes.h"

namespace hepatica::gpu {

constexpr int coarse_vectors = 4;  // per node, as vectors_per_node
constexpr int node_rows = 3 * coarse_vectors;
constexpr int cut_rows = 2 * node_rows;
constexpr int cut_entries = cut_rows * cut_rows;

// Column-major, so that threads of neighbouring rows read neighbouring entries.
HEPATICA_HOST_DEVICE int entry_of_cut(int row, int column) {
    return column * cut_rows + row;
}

// The motion of a node, aligned so that a device loads four numbers at once.
template <class Real>
struct alignas(16) NodeMotion {
    Real number[node_rows];
};

// Lists of CoarsePlan: the blocks of N column by column, and the updates that elimination subtracts
// from each block.
struct CutListsView {
    struct Update {
        int left, right;
    };
    View<const int> by_level, column_begin;
    View<const int> update_begin;
    View<const Update> update;
};

// The off-diagonal blocks of N^-1 row by row: one for each cut and each cut below it.
struct InverseListsView {
    // A block, and the cut of its row.
    struct Above {
        int block, cut;
    };
    // A block is minus the sum of such products of a block of N^-1 (-1: its diagonal, the identity)
    // and a block of N.
    struct Product {
        int inverse, factor;
    };
    View<const int> by_level;  // blocks, highest column cut first
    View<const int> column;    // of each block
    View<const int> product_begin;
    View<const Product> product;
    View<const int> chunk_begin,
        first_chunk;  // blocks of each chunk, which belong to one row; chunks of each row
    View<const int> above_begin;
    View<const Above> above;
};

// A pivot that elimination has reduced to this share of its initial value is rounding error; its
// vector is dropped from the coarse space. So are vectors that move nothing, whose pivots are zero
// from the start.
constexpr double least_pivot = 1e-10;

// Eliminates the cuts of one level: C_ip = A_ip - sum_k C_ik N_pk^T, D_p^-1 = (C_pp)^-1, N_ip =
// C_ip D_p^-1. A thread has one entry of every block.
template <class Real>
struct EliminateCuts {
    static constexpr int threads = cut_entries;
    // C_pp before and after a pivot; its initial diagonal; the reciprocals of this pivot and the
    // next
    static constexpr int shared = 2 * cut_entries + cut_rows + 2;
    CutListsView lists;
    int first, cuts;
    View<const double> matrix;
    View<double> reduced, multiplier;  // C, N
    View<double> pivot;                // D_p^-1 of each cut
    View<Real> factor;                 // N, rounded to Real

    int blocks() const { return cuts; }
    HEPATICA_HOST_DEVICE int phases() const { return 2 + cut_rows; }
    std::size_t bytes() const {
        const auto columns = static_cast<std::size_t>(cuts) * cut_entries;
        return columns * (5 * sizeof(double) + sizeof(Real));
    }
    HEPATICA_HOST_DEVICE void operator()(int phase, int block, int thread, double* own) const {
        const int cut = lists.by_level[first + block];
        if (phase == 0)
            reduce(cut, thread, own);
        else if (phase > cut_rows)
            finish(cut, thread, own);
        else
            turn_pivot(phase - 1, thread, own);
    }

  private:
    static constexpr int diagonal = 2 * cut_entries, scales = diagonal + cut_rows;
    static_assert(cut_rows % 2 == 0);  // so that the last pivot leaves C_pp in the first half

    // Reciprocal of pivot k after elimination, or 0 where it is dropped. One thread computes it for
    // all others.
    HEPATICA_HOST_DEVICE void set_scale(int k, double value, double* own) const {
        const bool alive = value > least_pivot * own[diagonal + k] && value > 0.0;
        own[scales + k % 2] = alive ? 1.0 / value : 0.0;
    }
    HEPATICA_HOST_DEVICE void reduce(int cut, int entry, double* own) const {
        const int row = entry % cut_rows, column = entry / cut_rows;
        const int begin = lists.column_begin[cut];
        for (int block = begin; block < lists.column_begin[cut + 1]; ++block) {
            double sum = matrix[cut_entries * block + entry];
            if (block == begin && row == column) own[diagonal + row] = sum;
            for (int u = lists.update_begin[block]; u < lists.update_begin[block + 1]; ++u) {
                const double* const left = reduced.data + cut_entries * lists.update[u].left;
                const double* const right = multiplier.data + cut_entries * lists.update[u].right;
                double product = 0.0;
                HEPATICA_UNROLL
                for (int c = 0; c < cut_rows; ++c)
                    product += left[entry_of_cut(row, c)] * right[entry_of_cut(column, c)];
                sum -= product;
            }
            reduced[cut_entries * block + entry] = sum;
            if (block == begin) own[entry] = sum;
            if (block == begin && entry == 0) set_scale(0, sum, own);
        }
    }
    // One step of Gauss-Jordan inversion, from one half of the memory into the other.
    HEPATICA_HOST_DEVICE void turn_pivot(int k, int entry, double* own) const {
        const double* const before = own + k % 2 * cut_entries;
        double& after = own[(1 - k % 2) * cut_entries + entry];
        const double scale = own[scales + k % 2];
        const int row = entry % cut_rows, column = entry / cut_rows;
        const double in_row = before[entry_of_cut(k, column)];
        const double in_column = before[entry_of_cut(row, k)];
        if (row == k)
            after = column == k ? scale : scale * in_row;
        else if (column == k)
            after = -scale * in_column;
        else
            after = before[entry] - scale * in_column * in_row;
        if (row == column && row == k + 1) set_scale(row, after, own);
    }
    HEPATICA_HOST_DEVICE void finish(int cut, int entry, const double* own) const {
        const int row = entry % cut_rows, column = entry / cut_rows;
        pivot[cut_entries * cut + entry] = 0.5 * (own[entry] + own[entry_of_cut(column, row)]);
        for (int block = lists.column_begin[cut] + 1; block < lists.column_begin[cut + 1];
             ++block) {
            const double* const left = reduced.data + cut_entries * block;
            double sum = 0.0;
            HEPATICA_UNROLL
            for (int c = 0; c < cut_rows; ++c)
                sum += left[entry_of_cut(row, c)] * own[entry_of_cut(c, column)];
            multiplier[cut_entries * block + entry] = sum;
            factor[cut_entries * block + entry] = Real(sum);
        }
    }
};

// Computes the blocks of N^-1 whose columns are of one level, after those of the levels above. A
// thread has one row and a few columns.
template <class Real>
struct InvertFactor {
    static constexpr int parts = 4, columns = cut_rows / parts;
    static constexpr int threads = cut_rows * parts, shared = 1;
    static_assert(columns * parts == cut_rows);
    InverseListsView lists;
    int first, count;
    View<const Real> factor;
    View<Real> inverse;

    int blocks() const { return count; }
    HEPATICA_HOST_DEVICE int phases() const { return 1; }
    std::size_t bytes() const {
        return 3 * static_cast<std::size_t>(count) * cut_entries * sizeof(Real);
    }
    HEPATICA_HOST_DEVICE void operator()(int, int at, int thread, double*) const {
        const int row = thread % cut_rows, begin = columns * (thread / cut_rows);
        const int block = lists.by_level[first + at];
        Real sum[columns] = {};
        for (int k = lists.product_begin[block]; k < lists.product_begin[block + 1]; ++k) {
            const InverseListsView::Product product = lists.product[k];
            const Real* const right = factor.data + cut_entries * product.factor;
            if (product.inverse < 0)
                for (int j = 0; j < columns; ++j) sum[j] -= right[entry_of_cut(row, begin + j)];
            else
                subtract(inverse.data + cut_entries * product.inverse + row,
                         right + entry_of_cut(0, begin), sum);
        }
        for (int j = 0; j < columns; ++j)
            inverse[cut_entries * block + entry_of_cut(row, begin + j)] = sum[j];
    }

  private:
    // Subtracts a row of the left factor times columns of the right one.
    HEPATICA_HOST_DEVICE static void subtract(const Real* left, const Real* right, Real* sum) {
        HEPATICA_UNROLL
        for (int c = 0; c < cut_rows; ++c) {
            const Real value = left[entry_of_cut(0, c)];
            for (int j = 0; j < columns; ++j) sum[j] -= value * right[entry_of_cut(c, j)];
        }
    }
};

// A solve is x = N^-T D^-1 N^-1 b, in three kernels with many threads each. Substitution would need
// one dependent launch per level instead. Eight threads share a row or column of a block, with
// three entries each, and one of them adds up the results.
struct CutThreads {
    static constexpr int parts = 8, each = cut_rows / parts;
    static constexpr int threads = cut_rows * parts, shared = threads;
    static_assert(each * parts == cut_rows);

    // Sum of a row's parts, which are cut_rows apart.
    HEPATICA_HOST_DEVICE static double add_up(const double* of_row) {
        double sum = 0.0;
        for (int part = 0; part < parts; ++part) sum += of_row[part * cut_rows];
        return sum;
    }
};

// The off-diagonal part of N^-1 b, by chunks.
template <class Real>
struct SumBelow : CutThreads {
    static constexpr int most_blocks = 8;  // blocks of a chunk
    InverseListsView lists;
    View<const Real> inverse;
    View<const double> load;  // cut_rows numbers for each cut, as in the following kernels
    View<double> partial;     // cut_rows numbers for each chunk

    int blocks() const { return lists.chunk_begin.size - 1; }
    HEPATICA_HOST_DEVICE int phases() const { return 2; }
    std::size_t bytes() const { return bytes_of(inverse, load, partial, lists.column); }
    HEPATICA_HOST_DEVICE void operator()(int phase, int chunk, int thread, double* sums) const {
        const int row = thread % cut_rows, first = each * (thread / cut_rows);
        if (phase == 0) {
            double sum = 0.0;
            for (int k = lists.chunk_begin[chunk]; k < lists.chunk_begin[chunk + 1]; ++k) {
                const Real* const entries = inverse.data + cut_entries * k;
                const double* const below = load.data + cut_rows * lists.column[k];
                HEPATICA_UNROLL
                for (int c = first; c < first + each; ++c)
                    sum += double(entries[entry_of_cut(row, c)]) * below[c];
            }
            sums[thread] = sum;
        } else if (thread < cut_rows) {
            partial[cut_rows * chunk + row] = add_up(sums + row);
        }
    }
};

// D^-1 times N^-1 b, whose off-diagonal part is the sum of the chunks and whose diagonal part is b.
template <class Real>
struct DivideByPivots : CutThreads {
    static constexpr int shared = threads + cut_rows;
    InverseListsView lists;
    View<const double>
        pivot;  // D^-1 in double: rounded to float it would not always be positive definite
    View<const double> load, partial;
    View<double> divided;

    int blocks() const { return lists.first_chunk.size - 1; }
    HEPATICA_HOST_DEVICE int phases() const { return 4; }
    std::size_t bytes() const { return bytes_of(pivot, load, partial, divided); }
    HEPATICA_HOST_DEVICE void operator()(int phase, int cut, int thread, double* sums) const {
        const int row = thread % cut_rows, part = thread / cut_rows;
        double* const whole = sums + threads;
        double sum = 0.0;
        if (phase == 0) {
            for (int chunk = lists.first_chunk[cut] + part; chunk < lists.first_chunk[cut + 1];
                 chunk += parts)
                sum += partial[cut_rows * chunk + row];
            sums[thread] = sum;
        } else if (phase == 2) {
            const double* const entries = pivot.data + cut_entries * cut;
            HEPATICA_UNROLL
            for (int c = each * part; c < each * (part + 1); ++c)
                sum += entries[entry_of_cut(row, c)] * whole[c];
            sums[thread] = sum;
        } else if (thread < cut_rows) {
            sum = add_up(sums + row);
            if (phase == 1)
                whole[row] = load[cut_rows * cut + row] + sum;
            else
                divided[cut_rows * cut + row] = sum;
        }
    }
};

// N^-T times that result.
template <class Real>
struct SumAbove : CutThreads {
    InverseListsView lists;
    View<const Real> inverse;
    View<const double> divided;
    View<NodeMotion<Real>> motion;  // of both nodes of each cut

    int blocks() const { return lists.above_begin.size - 1; }
    HEPATICA_HOST_DEVICE int phases() const { return 2; }
    std::size_t bytes() const { return bytes_of(inverse, divided, motion, lists.above); }
    HEPATICA_HOST_DEVICE void operator()(int phase, int cut, int thread, double* sums) const {
        if (phase == 0) {
            // Neighbouring threads read neighbouring rows of a column.
            const int column = thread / parts, first = each * (thread % parts);
            double sum = 0.0;
            for (int k = lists.above_begin[cut]; k < lists.above_begin[cut + 1]; ++k) {
                const InverseListsView::Above above = lists.above[k];
                const Real* const entries = inverse.data + cut_entries * above.block;
                const double* const higher = divided.data + cut_rows * above.cut;
                HEPATICA_UNROLL
                for (int r = first; r < first + each; ++r)
                    sum += double(entries[entry_of_cut(r, column)]) * higher[r];
            }
            sums[cut_rows * (thread % parts) + column] = sum;
        } else if (thread < cut_rows) {
            const int entry = cut_rows * cut + thread;
            motion[entry / node_rows].number[entry % node_rows] =
                Real(divided[entry] + add_up(sums + thread));
        }
    }
};

}  // namespace hepatica::gpu
