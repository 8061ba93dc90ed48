// SPDX-License-Identifier: GPL-3.0-or-later
// The factor N D N^T of the coarse matrix by cuts of two nodes (CoarsePlan), and its solve. One
// block of threads eliminates a cut: blocks are dense, gathered by lists, and no two blocks of
// threads of a level write one place.
#pragma once

#include "gpu/kernels/view.h"

// Loops whose loads a device has under way at once.
#ifdef __CUDACC__
#define HEPATICA_UNROLL _Pragma("unroll")
#else
#define HEPATICA_UNROLL
#endif

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
    struct Term {
        int block, cut;
    };
    struct Update {
        int left, right;
    };
    View<const int> by_level, column_begin, row, row_begin;
    View<const Term> in_row;
    View<const int> update_begin;
    View<const Update> update;
};

// A pivot that elimination has lowered to this share of what it was is rounding: its vector is left
// out of the coarse space. So are those that move nothing, whose pivots are zero from the start.
constexpr double least_pivot = 1e-10;

// Cuts of one level: C_ip = A_ip - sum_k C_ik N_pk^T, D_p = C_pp inverted, N_ip = C_ip D_p^-1. A
// thread has one entry of every block.
template <class Real>
struct EliminateCuts {
    static constexpr int threads = cut_entries;
    static constexpr int shared =
        2 * cut_entries + cut_rows;  // C_pp before and after a pivot; diagonal
    CutListsView lists;
    int first, cuts;
    View<const double> matrix;
    View<double> reduced, multiplier;  // C, N
    View<Real> inverse, factor;        // D_p^-1 of each cut; N, rounded

    int blocks() const { return cuts; }
    HEPATICA_HOST_DEVICE int phases() const { return 2 + cut_rows; }
    std::size_t bytes() const {
        const auto columns = static_cast<std::size_t>(cuts) * cut_entries;
        return columns * (4 * sizeof(double) + 2 * sizeof(Real));
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
    static constexpr int diagonal = 2 * cut_entries;  // before elimination
    static_assert(cut_rows % 2 == 0);                 // the last pivot leaves C_pp at the front

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
        }
    }
    // A step of Gauss and Jordan's inversion, from one half of the memory into the other.
    HEPATICA_HOST_DEVICE void turn_pivot(int pivot, int entry, double* own) const {
        const double* const before = own + pivot % 2 * cut_entries;
        double& after = own[(1 - pivot % 2) * cut_entries + entry];
        const double value = before[entry_of_cut(pivot, pivot)];
        const bool alive = value > least_pivot * own[diagonal + pivot] && value > 0.0;
        const double scale = alive ? 1.0 / value : 0.0;
        const int row = entry % cut_rows, column = entry / cut_rows;
        const double in_row = before[entry_of_cut(pivot, column)];
        const double in_column = before[entry_of_cut(row, pivot)];
        if (row == pivot)
            after = column == pivot ? scale : scale * in_row;
        else if (column == pivot)
            after = -scale * in_column;
        else
            after = before[entry] - scale * in_column * in_row;
    }
    HEPATICA_HOST_DEVICE void finish(int cut, int entry, const double* own) const {
        const int row = entry % cut_rows, column = entry / cut_rows;
        inverse[cut_entries * cut + entry] =
            Real(0.5 * (own[entry] + own[entry_of_cut(column, row)]));
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

// Which way a solve goes through its stages: g = N^-1 b in place of the load, then
// x = N^-T D^-1 g as the motion.
enum class CutSolve { forward, backward, both };

// Cuts of a stage at most, as many as partial sums have room for.
constexpr int most_cuts_of_stage = 16;

// Eight threads a row, each with three columns of every block; then one adds them up.
template <class Real>
struct SolveCuts {
    static constexpr int parts = 8, columns = cut_rows / parts;
    static constexpr int per_cut = cut_rows * parts, threads = 4 * per_cut;
    static constexpr int shared = most_cuts_of_stage * per_cut;
    CutListsView lists;
    int solved;  // cuts in all
    int stages;
    View<const int> begin;  // CutStages
    CutSolve way;
    View<const Real> inverse, factor;
    View<double> load, motion;  // cut_rows for each cut

    int blocks() const { return stages > 0 ? begin.size / (stages + 1) : 0; }
    HEPATICA_HOST_DEVICE int phases() const {
        return 2 * (way == CutSolve::both ? 2 * stages : stages);
    }
    std::size_t bytes() const {
        const auto cuts = static_cast<std::size_t>(solved);
        const std::size_t entries = cuts * cut_entries * sizeof(Real);
        const std::size_t once = entries * 2 + cuts * cut_rows * 2 * sizeof(double);
        return way == CutSolve::both ? 2 * once : once;
    }
    HEPATICA_HOST_DEVICE void operator()(int phase, int row, int thread, double* sums) const {
        const int step = phase / 2;
        const bool forward = way == CutSolve::forward || (way == CutSolve::both && step < stages);
        int stage = step;
        if (!forward) stage = (way == CutSolve::both ? 2 * stages : stages) - 1 - step;
        const int at = row * (stages + 1) + stage;
        const int first = begin[at], cuts = begin[at + 1] - first;
        if (phase % 2 == 0) {
            for (int k = thread; k < cuts * per_cut; k += threads)
                sums[k] = forward ? eliminate(first + k / per_cut, k % cut_rows, part_of(k))
                                  : substitute(first + k / per_cut, k % cut_rows, part_of(k));
        } else {
            for (int k = thread; k < cuts * cut_rows; k += threads)
                add_up(first + k / cut_rows, k % cut_rows,
                       sums + k / cut_rows * per_cut + k % cut_rows, forward);
        }
    }

  private:
    HEPATICA_HOST_DEVICE int part_of(int k) const { return k % per_cut / cut_rows; }

    // g_p = b_p - sum_k N_pk g_k: of the sum, some columns.
    HEPATICA_HOST_DEVICE double eliminate(int own, int r, int part) const {
        double sum = 0.0;
        for (int k = lists.row_begin[own]; k < lists.row_begin[own + 1]; ++k) {
            const CutListsView::Term term = lists.in_row[k];
            const Real* const entries = factor.data + cut_entries * term.block;
            const double* const below = load.data + cut_rows * term.cut;
            HEPATICA_UNROLL
            for (int c = columns * part; c < columns * (part + 1); ++c)
                sum -= double(entries[entry_of_cut(r, c)]) * below[c];
        }
        return sum;
    }
    // x_p = D_p^-1 g_p - sum_i N_ip^T x_i, likewise.
    HEPATICA_HOST_DEVICE double substitute(int own, int r, int part) const {
        const Real* const diagonal = inverse.data + cut_entries * own;
        const double* const reduced = load.data + cut_rows * own;
        double sum = 0.0;
        HEPATICA_UNROLL
        for (int c = columns * part; c < columns * (part + 1); ++c)
            sum += double(diagonal[entry_of_cut(r, c)]) * reduced[c];
        for (int block = lists.column_begin[own] + 1; block < lists.column_begin[own + 1];
             ++block) {
            const Real* const entries = factor.data + cut_entries * block;
            const double* const above = motion.data + cut_rows * lists.row[block];
            HEPATICA_UNROLL
            for (int c = columns * part; c < columns * (part + 1); ++c)
                sum -= double(entries[entry_of_cut(c, r)]) * above[c];
        }
        return sum;
    }
    HEPATICA_HOST_DEVICE void add_up(int own, int r, const double* parts_of_row,
                                     bool forward) const {
        double sum = forward ? load[cut_rows * own + r] : 0.0;
        for (int part = 0; part < parts; ++part) sum += parts_of_row[part * cut_rows];
        (forward ? load : motion)[cut_rows * own + r] = sum;
    }
};

}  // namespace hepatica::gpu
