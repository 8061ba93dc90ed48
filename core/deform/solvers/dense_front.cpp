// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/solvers/dense_front.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>

#include "core/base/parallel.h"
#include "core/base/stop.h"

namespace hepatica {

namespace {

template <class T>
struct PacketOf {
    typedef T Type __attribute__((vector_size(32)));  // NOLINT: a vector type has no using
};
template <class T>
using Packet = typename PacketOf<T>::Type;
template <class T>
constexpr int lanes = front_alignment<T>;

template <class T>
Packet<T> load(const T* p) {
    Packet<T> value;
    std::memcpy(&value, p, sizeof value);
    return value;
}

template <class T>
void store(T* p, const Packet<T>& value) {
    std::memcpy(p, &value, sizeof value);
}

template <class T>
T sum_of(const Packet<T>& packet) {
    if constexpr (lanes<T> == 4)
        return (packet[0] + packet[1]) + (packet[2] + packet[3]);
    else
        return ((packet[0] + packet[1]) + (packet[2] + packet[3])) +
               ((packet[4] + packet[5]) + (packet[6] + packet[7]));
}

// target(0:4R, 0:C) -= a(0:4R, 0:depth) b(0:C, 0:depth)^T; all column-major, a and b with the same
// leading dimension. Sums stay in registers.
template <int R, int C, class T>
void subtract_tile(const T* a, const T* b, std::ptrdiff_t stride, int depth, T* target,
                   std::ptrdiff_t target_stride) {
    std::array<std::array<Packet<T>, R>, C> sum{};
    for (int p = 0; p < depth; ++p) {
        std::array<Packet<T>, R> left;
        for (int r = 0; r < R; ++r) left[r] = load<T>(a + r * lanes<T>);
        for (int c = 0; c < C; ++c) {
            for (int r = 0; r < R; ++r) sum[c][r] += left[r] * b[c];
        }
        a += stride;
        b += stride;
    }
    for (int c = 0; c < C; ++c) {
        for (int r = 0; r < R; ++r) {
            T* place = target + c * target_stride + r * lanes<T>;
            store<T>(place, load<T>(place) - sum[c][r]);
        }
    }
}

// Rows [0, rows) of C columns, rounded up to whole packets. What is computed beyond them is garbage
// in rows above the next column's diagonal or in the slack.
template <int C, class T>
void subtract_rows(const T* a, const T* b, std::ptrdiff_t stride, int depth, T* target,
                   std::ptrdiff_t target_stride, int rows) {
    int i = 0;
    for (; i + 3 * lanes<T> <= rows; i += 3 * lanes<T>) {
        subtract_tile<3, C>(a + i, b, stride, depth, target + i, target_stride);
    }
    for (; i < rows; i += lanes<T>) {
        subtract_tile<1, C>(a + i, b, stride, depth, target + i, target_stride);
    }
}

template <class T>
void subtract_columns(int columns, const T* a, const T* b, std::ptrdiff_t stride, int depth,
                      T* target, std::ptrdiff_t target_stride, int rows) {
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
// Fronts with at least `deep` pivots are shared by several threads, in pieces of this size. Every
// entry is summed in the same order as by one thread.
constexpr int deep = 96;
constexpr std::size_t shared_rows = 192, shared_strips = 6;

// Unblocked elimination of `columns` columns to which all earlier columns have been applied.
template <class T>
int eliminate_strip(T* panel, std::ptrdiff_t stride, int first, int columns,
                    const T* entry_diagonal, const PivotRule& rule) {
    int lost = 0;
    for (int j = first; j < first + columns; ++j) {
        T* column = panel + j * stride;
        for (int p = first; p < j; ++p) {
            const T* earlier = panel + p * stride;
            const T factor = earlier[j];
            for (int i = j; i < stride; ++i) column[i] -= factor * earlier[i];
        }
        T pivot = column[j];
        if (!(pivot > static_cast<T>(rule.smallest) * entry_diagonal[j - first])) {
            ++lost;
            if (rule.drop || !(entry_diagonal[j - first] > T(0))) {
                std::fill(column + j, column + stride, T(0));
                column[j] = std::numeric_limits<T>::infinity();
                continue;
            }
            pivot = entry_diagonal[j - first];
        }
        const T root = std::sqrt(pivot);
        const T inverse = T(1) / root;
        for (int i = j + 1; i < stride; ++i) column[i] *= inverse;
        column[j] = root;
    }
    return lost;
}

}  // namespace

template <class T>
int factor_front(T* panel, T* remainder, int pivots, int rest, PivotRule rule,
                 const std::stop_token& stop) {
    const std::ptrdiff_t stride = padded<T>(pivots + rest);
    int lost = 0;
    for (int j = 0; j < pivots; j += strip) {
        throw_if_stopped(stop);
        const int columns = std::min(strip, pivots - j);
        std::array<T, strip> diagonal{};
        for (int c = 0; c < columns; ++c) diagonal[c] = panel[(j + c) * stride + j + c];
        const auto rows = static_cast<std::size_t>(stride - j);
        parallel_blocks(rows, j < deep ? rows : shared_rows, [&](std::size_t begin, auto end) {
            subtract_columns(columns, panel + j + begin, panel + j, stride, j,
                             panel + j * stride + j + begin, stride, static_cast<int>(end - begin));
        });
        lost += eliminate_strip(panel, stride, j, columns, diagonal.data(), rule);
    }
    const std::ptrdiff_t rest_stride = padded<T>(rest);
    if (rest == 0) return lost;
    const auto strips = static_cast<std::size_t>((rest + strip - 1) / strip);
    parallel_blocks(strips, pivots < deep ? strips : shared_strips, [&](auto begin, auto end) {
        for (int j = strip * static_cast<int>(begin);
             j < std::min(rest, strip * static_cast<int>(end)); j += strip) {
            throw_if_stopped(stop);
            const T* rows = panel + pivots + j;
            subtract_columns(std::min(strip, rest - j), rows, rows, stride, pivots,
                             remainder + j * rest_stride + j, rest_stride, padded<T>(rest - j));
        }
    });
    return lost;
}

template <class T>
void forward_front(const T* panel, int pivots, int rest, T* head, T* tail) {
    const std::ptrdiff_t stride = padded<T>(pivots + rest);
    for (int j = 0; j < pivots; ++j) {
        const T* column = panel + j * stride;
        const T value = head[j] / column[j];
        head[j] = value;
        for (int i = j + 1; i < pivots; ++i) head[i] -= column[i] * value;
        for (int i = 0; i < rest; ++i) tail[i] -= column[pivots + i] * value;
    }
}

template <class T>
void backward_front(const T* panel, int pivots, int rest, T* head, const T* tail) {
    const std::ptrdiff_t stride = padded<T>(pivots + rest);
    for (int j = pivots - 1; j >= 0; --j) {
        const T* column = panel + j * stride;
        Packet<T> sums{};
        int i = 0;
        for (; i + lanes<T> <= rest; i += lanes<T>)
            sums += load<T>(column + pivots + i) * load<T>(tail + i);
        T sum = sum_of<T>(sums);
        for (; i < rest; ++i) sum += column[pivots + i] * tail[i];
        for (i = j + 1; i < pivots; ++i) sum += column[i] * head[i];
        head[j] = (head[j] - sum) / column[j];
    }
}

template int factor_front(double*, double*, int, int, PivotRule, const std::stop_token&);
template int factor_front(float*, float*, int, int, PivotRule, const std::stop_token&);
template void forward_front(const double*, int, int, double*, double*);
template void forward_front(const float*, int, int, float*, float*);
template void backward_front(const double*, int, int, double*, const double*);
template void backward_front(const float*, int, int, float*, const float*);

}  // namespace hepatica
