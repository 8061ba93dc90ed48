// SPDX-License-Identifier: GPL-3.0-or-later
// Dense kernels of the sparse factorisation: partial Cholesky of one front, and triangular solves
// with its panel. T is double, or float where the factor is a preconditioner.
#pragma once

#include <cstddef>
#include <stop_token>

namespace hepatica {

// Vector registers hold this many scalars; leading dimensions are multiples of it.
template <class T>
constexpr int front_alignment = static_cast<int>(32 / sizeof(T));

template <class T>
constexpr int padded(int rows) {
    return (rows + front_alignment<T> - 1) / front_alignment<T> * front_alignment<T>;
}

struct PivotRule {
    double smallest;
    // Dropped: the column of L becomes zero with an infinite diagonal, so that solves give zero
    // there. Otherwise the pivot is raised to its value on entry, and L L^T stays positive
    // definite.
    bool drop;
};

// A front has `pivots` columns to eliminate and `rest` columns that remain. The panel is
// column-major, padded(pivots + rest) by pivots; its lower part holds the front's first columns on
// entry and those of L on exit. The remainder is column-major, padded(rest) by rest, lower part; on
// exit L21 L21^T is subtracted from it, and its padding rows hold garbage. Both need
// front_alignment scalars of slack after their end: they are read and written, never used, and no
// scalar beyond them is touched. Pivots not above `smallest` times their value on entry are treated
// by the rule; returns their number. Throws Cancelled between two strips of columns after a stop is
// requested.
template <class T>
int factor_front(T* panel, T* remainder, int pivots, int rest, PivotRule rule,
                 const std::stop_token& stop = {});

// x holds the front's right-hand side: `pivots` entries, `rest` entries, and zeros up to
// padded(pivots + rest); both parts of L stand in the panel.
// x1 := L11^-1 x1; x2 -= L21 x1.
template <class T>
void forward_front(const T* panel, int pivots, int rest, T* x);

// x1 := L11^-T (x1 - L21^T x2).
template <class T>
void backward_front(const T* panel, int pivots, int rest, T* x);

}  // namespace hepatica
