// SPDX-License-Identifier: GPL-3.0-or-later
// The factor N D N^T of the coarse matrix by cuts of two nodes (CoarsePlan), and its solve. One
// block of threads eliminates a cut: blocks are dense, gathered by lists, and no two blocks of
// threads of a level write one place.
#pragma once

#include "gpu/kernels/view.h"

namespace hepatica::gpu {

constexpr int coarse_vectors = 4;  // per node, as vectors_per_node
constexpr int cut_rows = 2 * 3 * coarse_vectors;
constexpr int cut_entries = cut_rows * cut_rows;

// By columns, so that threads of neighbouring rows read neighbouring entries.
HEPATICA_HOST_DEVICE int entry_of_cut(int row, int column) {
    return column * cut_rows + row;
}

// The lists of CoarsePlan.
struct CutListsView {
    View<const int> column_begin, row, column;
    View<const int> row_begin, in_row;
    View<const int> update_begin;
    struct Update {
        int left, right;
    };
    View<const Update> update;
};

// A pivot that elimination has lowered to this share of what it was is rounding: its vector is left
// out of the coarse space. So are those that move nothing, whose pivots are zero from the start.
constexpr double least_pivot = 1e-10;

// Cuts of one level: C_ip = A_ip - sum_k C_ik N_pk^T, D_p = C_pp inverted, N_ip = C_ip D_p^-1.
template <class Real>
struct EliminateCuts {
    static constexpr int threads = 256;
    static constexpr int shared = cut_entries + 2 * cut_rows;  // C_pp; a row and a column of it
    CutListsView lists;
    int first, cuts;
    View<const double> matrix;
    View<double> reduced, multiplier;  // C, N
    View<Real> inverse, factor;        // D_p^-1 of each cut; N, rounded

    static constexpr int pivot_phases = 2 * cut_rows;
    int blocks() const { return cuts; }
    HEPATICA_HOST_DEVICE int phases() const { return 2 + pivot_phases; }
    std::size_t bytes() const {
        const auto columns = static_cast<std::size_t>(cuts) * cut_entries;
        return columns * (4 * sizeof(double) + 2 * sizeof(Real));
    }
    HEPATICA_HOST_DEVICE void operator()(int phase, int block, int thread, double* own) const {
        const int cut = first + block;
        if (phase == 0)
            reduce(cut, thread, own);
        else if (phase > pivot_phases)
            finish(cut, thread, own);
        else if (phase % 2 == 1)
            keep_pivot((phase - 1) / 2, thread, own);
        else
            turn_pivot((phase - 1) / 2, cut, thread, own);
    }

  private:
    HEPATICA_HOST_DEVICE void reduce(int cut, int thread, double* own) const {
        const int begin = lists.column_begin[cut];
        const int entries = cut_entries * (lists.column_begin[cut + 1] - begin);
        for (int k = thread; k < entries; k += threads) {
            const int block = begin + k / cut_entries, entry = k % cut_entries;
            const int row = entry % cut_rows, column = entry / cut_rows;
            double sum = matrix[cut_entries * block + entry];
            for (int u = lists.update_begin[block]; u < lists.update_begin[block + 1]; ++u) {
                const double* const left = reduced.data + cut_entries * lists.update[u].left;
                const double* const right = multiplier.data + cut_entries * lists.update[u].right;
                for (int c = 0; c < cut_rows; ++c)
                    sum -= left[entry_of_cut(row, c)] * right[entry_of_cut(column, c)];
            }
            reduced[cut_entries * block + entry] = sum;
            if (block == begin) own[entry] = sum;
        }
    }
    HEPATICA_HOST_DEVICE void keep_pivot(int pivot, int thread, double* own) const {
        if (thread >= cut_rows) return;
        own[cut_entries + thread] = own[entry_of_cut(pivot, thread)];
        own[cut_entries + cut_rows + thread] = own[entry_of_cut(thread, pivot)];
    }
    // A step of Gauss and Jordan's inversion in place.
    HEPATICA_HOST_DEVICE void turn_pivot(int pivot, int cut, int thread, double* own) const {
        const double* const in_row = own + cut_entries;
        const double* const in_column = in_row + cut_rows;
        const double before =
            matrix[cut_entries * lists.column_begin[cut] + entry_of_cut(pivot, pivot)];
        const bool alive = in_row[pivot] > least_pivot * before && in_row[pivot] > 0.0;
        const double scale = alive ? 1.0 / in_row[pivot] : 0.0;
        for (int entry = thread; entry < cut_entries; entry += threads) {
            const int row = entry % cut_rows, column = entry / cut_rows;
            double& value = own[entry];
            if (row == pivot)
                value = column == pivot ? scale : scale * in_row[column];
            else if (column == pivot)
                value = -scale * in_column[row];
            else
                value -= scale * in_column[row] * in_row[column];
        }
    }
    HEPATICA_HOST_DEVICE void finish(int cut, int thread, const double* own) const {
        const int begin = lists.column_begin[cut];
        for (int entry = thread; entry < cut_entries; entry += threads) {
            const int row = entry % cut_rows, column = entry / cut_rows;
            inverse[cut_entries * cut + entry] =
                Real(0.5 * (own[entry] + own[entry_of_cut(column, row)]));
        }
        const int entries = cut_entries * (lists.column_begin[cut + 1] - begin - 1);
        for (int k = thread; k < entries; k += threads) {
            const int block = begin + 1 + k / cut_entries, entry = k % cut_entries;
            const int row = entry % cut_rows, column = entry / cut_rows;
            const double* const left = reduced.data + cut_entries * block;
            double sum = 0.0;
            for (int c = 0; c < cut_rows; ++c)
                sum += left[entry_of_cut(row, c)] * own[entry_of_cut(c, column)];
            multiplier[cut_entries * block + entry] = sum;
            factor[cut_entries * block + entry] = Real(sum);
        }
    }
};

// Which way a solve goes through its stages: g = N^-1 b in place of the load, then
// x = N^-T D^-1 g as the motion.
enum class CutSolve { forward, backward, both };

template <class Real>
struct SolveCuts {
    static constexpr int threads = 256, shared = 1;
    CutListsView lists;
    int stages;
    View<const int> begin, cut;  // CutStages
    CutSolve way;
    View<const Real> inverse, factor;
    View<double> load, motion;  // cut_rows for each cut

    int blocks() const { return stages > 0 ? begin.size / (stages + 1) : 0; }
    HEPATICA_HOST_DEVICE int phases() const { return way == CutSolve::both ? 2 * stages : stages; }
    std::size_t bytes() const {
        const auto cuts = static_cast<std::size_t>(cut.size);
        const std::size_t entries = cuts * cut_entries * sizeof(Real);
        const std::size_t once = entries * 2 + cuts * cut_rows * 2 * sizeof(double);
        return way == CutSolve::both ? 2 * once : once;
    }
    HEPATICA_HOST_DEVICE void operator()(int phase, int row, int thread, double*) const {
        const bool forward = way == CutSolve::forward || (way == CutSolve::both && phase < stages);
        int stage = phase;
        if (!forward) stage = (way == CutSolve::both ? 2 * stages : stages) - 1 - phase;
        const int at = row * (stages + 1) + stage;
        const int end = cut_rows * begin[at + 1];
        for (int k = cut_rows * begin[at] + thread; k < end; k += threads) {
            const int own = cut[k / cut_rows];
            if (forward)
                eliminate(own, k % cut_rows);
            else
                substitute(own, k % cut_rows);
        }
    }

  private:
    // g_p = b_p - sum_k N_pk g_k
    HEPATICA_HOST_DEVICE void eliminate(int own, int r) const {
        double sum = load[cut_rows * own + r];
        for (int k = lists.row_begin[own]; k < lists.row_begin[own + 1]; ++k) {
            const int block = lists.in_row[k];
            const Real* const entries = factor.data + cut_entries * block;
            const double* const below = load.data + cut_rows * lists.column[block];
            for (int c = 0; c < cut_rows; ++c)
                sum -= double(entries[entry_of_cut(r, c)]) * below[c];
        }
        load[cut_rows * own + r] = sum;
    }
    // x_p = D_p^-1 g_p - sum_i N_ip^T x_i
    HEPATICA_HOST_DEVICE void substitute(int own, int r) const {
        const Real* const diagonal = inverse.data + cut_entries * own;
        const double* const reduced = load.data + cut_rows * own;
        double sum = 0.0;
        for (int c = 0; c < cut_rows; ++c) sum += double(diagonal[entry_of_cut(r, c)]) * reduced[c];
        for (int block = lists.column_begin[own] + 1; block < lists.column_begin[own + 1];
             ++block) {
            const Real* const entries = factor.data + cut_entries * block;
            const double* const above = motion.data + cut_rows * lists.row[block];
            for (int c = 0; c < cut_rows; ++c)
                sum -= double(entries[entry_of_cut(c, r)]) * above[c];
        }
        motion[cut_rows * own + r] = sum;
    }
};

}  // namespace hepatica::gpu
