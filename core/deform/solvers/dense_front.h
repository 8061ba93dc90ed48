// SPDX-License-Identifier: GPL-3.0-or-later
// The dense arithmetic of the sparse factorisation: partial Cholesky of one front, and the
// triangular solves with its panel.
#pragma once

#include <cstddef>

namespace hepatica {

// Vector registers hold this many doubles; leading dimensions are multiples of it.
constexpr int front_alignment = 4;

inline int padded(int rows) {
    return (rows + front_alignment - 1) / front_alignment * front_alignment;
}

// A front of `pivots` columns to eliminate and `rest` that remain. The panel is column-major,
// padded(pivots + rest) by pivots; on entry its lower part holds the front's first columns, on exit
// those of L. The remainder is column-major, padded(rest) by rest, lower part: on exit it has had
// L21 L21^T taken away; its rows of padding are garbage. Both need front_alignment doubles of slack
// behind their end, which are read but not used.
// A pivot that is not above `smallest` times its entry value is dropped: its column of L becomes
// zero but for an infinite diagonal, so that solves give zero there. Returns how many were dropped.
int factor_front(double* panel, double* remainder, int pivots, int rest, double smallest);

// head := L11^-1 head; tail -= L21 head.
void forward_front(const double* panel, int pivots, int rest, double* head, double* tail);

// head := L11^-T (head - L21^T tail).
void backward_front(const double* panel, int pivots, int rest, double* head, const double* tail);

}  // namespace hepatica
