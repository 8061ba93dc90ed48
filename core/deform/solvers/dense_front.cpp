// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/solvers/dense_front.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>

namespace hepatica {

namespace {

using Packet = double __attribute__((vector_size(32)));
constexpr int lanes = front_alignment;

Packet load(const double* p) {
    Packet value;
    std::memcpy(&value, p, sizeof value);
    return value;
}

void store(double* p, const Packet& value) {
    std::memcpy(p, &value, sizeof value);
}

// target(0:4R, 0:C) -= a(0:4R, 0:depth) b(0:C, 0:depth)^T; all column-major, a and b with the same
// leading dimension. Held in registers throughout.
template <int R, int C>
void subtract_tile(const double* a, const double* b, std::ptrdiff_t stride, int depth,
                   double* target, std::ptrdiff_t target_stride) {
    std::array<std::array<Packet, R>, C> sum{};
    for (int p = 0; p < depth; ++p) {
        std::array<Packet, R> left;
        for (int r = 0; r < R; ++r) left[r] = load(a + r * lanes);
        for (int c = 0; c < C; ++c) {
            for (int r = 0; r < R; ++r) sum[c][r] += left[r] * b[c];
        }
        a += stride;
        b += stride;
    }
    for (int c = 0; c < C; ++c) {
        for (int r = 0; r < R; ++r) {
            double* place = target + c * target_stride + r * lanes;
            store(place, load(place) - sum[c][r]);
        }
    }
}

// Rows [0, rows) of C columns, rows a multiple of the packet after padding.
template <int C>
void subtract_rows(const double* a, const double* b, std::ptrdiff_t stride, int depth,
                   double* target, std::ptrdiff_t target_stride, int rows) {
    int i = 0;
    for (; i + 3 * lanes <= rows; i += 3 * lanes) {
        subtract_tile<3, C>(a + i, b, stride, depth, target + i, target_stride);
    }
    for (; i < rows; i += lanes) {
        subtract_tile<1, C>(a + i, b, stride, depth, target + i, target_stride);
    }
}

void subtract_columns(int columns, const double* a, const double* b, std::ptrdiff_t stride,
                      int depth, double* target, std::ptrdiff_t target_stride, int rows) {
    switch (columns) {
        case 1:
            return subtract_rows<1>(a, b, stride, depth, target, target_stride, rows);
        case 2:
            return subtract_rows<2>(a, b, stride, depth, target, target_stride, rows);
        case 3:
            return subtract_rows<3>(a, b, stride, depth, target, target_stride, rows);
        default:
            return subtract_rows<4>(a, b, stride, depth, target, target_stride, rows);
    }
}

constexpr int strip = 4;  // columns that are eliminated together

// Unblocked elimination of `columns` columns whose earlier updates are all in.
int eliminate_strip(double* panel, std::ptrdiff_t stride, int first, int columns,
                    const double* entry_diagonal, double smallest) {
    int dropped = 0;
    for (int j = first; j < first + columns; ++j) {
        double* column = panel + j * stride;
        for (int p = first; p < j; ++p) {
            const double* earlier = panel + p * stride;
            const double factor = earlier[j];
            for (int i = j; i < stride; ++i) column[i] -= factor * earlier[i];
        }
        const double pivot = column[j];
        if (!(pivot > smallest * entry_diagonal[j - first])) {
            std::fill(column + j, column + stride, 0.0);
            column[j] = std::numeric_limits<double>::infinity();
            ++dropped;
            continue;
        }
        const double root = std::sqrt(pivot);
        const double inverse = 1.0 / root;
        for (int i = j + 1; i < stride; ++i) column[i] *= inverse;
        column[j] = root;
    }
    return dropped;
}

}  // namespace

int factor_front(double* panel, double* remainder, int pivots, int rest, double smallest) {
    const std::ptrdiff_t stride = padded(pivots + rest);
    int dropped = 0;
    for (int j = 0; j < pivots; j += strip) {
        const int columns = std::min(strip, pivots - j);
        std::array<double, strip> diagonal{};
        for (int c = 0; c < columns; ++c) diagonal[c] = panel[(j + c) * stride + j + c];
        subtract_columns(columns, panel + j, panel + j, stride, j, panel + j * stride + j, stride,
                         static_cast<int>(stride) - j);
        dropped += eliminate_strip(panel, stride, j, columns, diagonal.data(), smallest);
    }
    const std::ptrdiff_t rest_stride = padded(rest);
    for (int j = 0; j < rest; j += strip) {
        const double* rows = panel + pivots + j;
        subtract_columns(std::min(strip, rest - j), rows, rows, stride, pivots,
                         remainder + j * rest_stride + j, rest_stride, padded(rest) - j);
    }
    return dropped;
}

void forward_front(const double* panel, int pivots, int rest, double* head, double* tail) {
    const std::ptrdiff_t stride = padded(pivots + rest);
    for (int j = 0; j < pivots; ++j) {
        const double* column = panel + j * stride;
        const double value = head[j] / column[j];
        head[j] = value;
        for (int i = j + 1; i < pivots; ++i) head[i] -= column[i] * value;
        for (int i = 0; i < rest; ++i) tail[i] -= column[pivots + i] * value;
    }
}

void backward_front(const double* panel, int pivots, int rest, double* head, const double* tail) {
    const std::ptrdiff_t stride = padded(pivots + rest);
    for (int j = pivots - 1; j >= 0; --j) {
        const double* column = panel + j * stride;
        Packet sums{};
        int i = 0;
        for (; i + lanes <= rest; i += lanes) sums += load(column + pivots + i) * load(tail + i);
        double sum = (sums[0] + sums[1]) + (sums[2] + sums[3]);
        for (; i < rest; ++i) sum += column[pivots + i] * tail[i];
        for (i = j + 1; i < pivots; ++i) sum += column[i] * head[i];
        head[j] = (head[j] - sum) / column[j];
    }
}

}  // namespace hepatica
