// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/solvers/dense_front.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/base/parallel.h"
#include "core/base/stop.h"

namespace hepatica {

namespace {

template <class T>
struct PacketOf {
    // NOLINTBEGIN: a vector type has no using
    typedef T Type __attribute__((vector_size(32)));
    typedef T Anywhere __attribute__((vector_size(32), aligned(sizeof(T)), may_alias));
    // NOLINTEND
};
template <class T>
using Packet = typename PacketOf<T>::Type;
template <class T>
constexpr int lanes = front_alignment<T>;

template <class T>
Packet<T> load(const T* p) {
    return *reinterpret_cast<const typename PacketOf<T>::Anywhere*>(p);
}

template <class T>
void store(T* p, const Packet<T>& value) {
    *reinterpret_cast<typename PacketOf<T>::Anywhere*>(p) = value;
}

template <class T>
T sum_of(const Packet<T>& packet) {
    if constexpr (lanes<T> == 4)
        return (packet[0] + packet[1]) + (packet[2] + packet[3]);
    else
        return ((packet[0] + packet[1]) + (packet[2] + packet[3])) +
               ((packet[4] + packet[5]) + (packet[6] + packet[7]));
}

// Calls visit.operator()<C>() with the number of columns as a constant.
template <class Visit>
void with_columns(int columns, const Visit& visit) {
    switch (columns) {
        case 1:
            return visit.template operator()<1>();
        case 2:
            return visit.template operator()<2>();
        case 3:
            return visit.template operator()<3>();
        default:
            return visit.template operator()<4>();
    }
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
    for (; i + 2 * lanes<T> < rows; i += 3 * lanes<T>)
        subtract_tile<3, C>(a + i, b, stride, depth, target + i, target_stride);
    if (i + lanes<T> < rows)
        subtract_tile<2, C>(a + i, b, stride, depth, target + i, target_stride);
    else if (i < rows)
        subtract_tile<1, C>(a + i, b, stride, depth, target + i, target_stride);
}

// First row of the packet that a row lies in.
template <class T>
std::ptrdiff_t packet_of(int row) {
    return row / lanes<T> * lanes<T>;
}

constexpr int strip = 4;  // columns that are eliminated together
// Fronts with at least `deep` pivots are shared by several threads, in pieces of this size. Every
// entry is summed in the same order as by one thread.
constexpr int deep = 96;
constexpr std::size_t shared_rows = 192, shared_strips = 6;

// The rows and columns of a strip that meet: lower triangle of L, and 1 / L(c, c).
template <class T>
struct StripCorner {
    std::array<std::array<T, strip>, strip> entry;  // entry[column][row]
    std::array<T, strip> inverse;
    int lost;
};

// Eliminates the corner alone. A dropped column is zero with an infinite diagonal; its inverse is
// 0.
template <int C, class T>
void eliminate_corner(const T* from, std::ptrdiff_t stride, const T* entry_diagonal,
                      const PivotRule& rule, StripCorner<T>& corner) {
    auto& entry = corner.entry;
    corner.lost = 0;
    for (int c = 0; c < C; ++c)
        for (int r = 0; r < C; ++r) entry[c][r] = from[c * stride + r];
    for (int c = 0; c < C; ++c) {
        for (int p = 0; p < c; ++p)
            for (int r = c; r < C; ++r) entry[c][r] -= entry[p][c] * entry[p][r];
        T pivot = entry[c][c];
        corner.inverse[c] = T(0);
        if (!(pivot > static_cast<T>(rule.smallest) * entry_diagonal[c])) {
            ++corner.lost;
            if (rule.drop || !(entry_diagonal[c] > T(0))) {
                for (int r = c + 1; r < C; ++r) entry[c][r] = T(0);
                entry[c][c] = std::numeric_limits<T>::infinity();
                continue;
            }
            pivot = entry_diagonal[c];
        }
        const T root = std::sqrt(pivot);
        corner.inverse[c] = T(1) / root;
        for (int r = c + 1; r < C; ++r) entry[c][r] *= corner.inverse[c];
        entry[c][c] = root;
    }
}

// Unblocked elimination of C columns to which all earlier columns have been applied. Whole packets
// are computed from the one that the strip's first row lies in; what is above the diagonal becomes
// garbage.
template <int C, class T>
int eliminate_columns(T* panel, std::ptrdiff_t stride, int first, const T* entry_diagonal,
                      const PivotRule& rule) {
    T* columns = panel + first * stride;
    StripCorner<T> corner;
    eliminate_corner<C>(columns + first, stride, entry_diagonal, rule, corner);
    for (std::ptrdiff_t i = packet_of<T>(first); i < stride; i += lanes<T>) {
        Packet<T> value[C];
        for (int c = 0; c < C; ++c) {
            value[c] = load<T>(columns + c * stride + i);
            for (int p = 0; p < c; ++p) value[c] -= corner.entry[p][c] * value[p];
            value[c] = corner.inverse[c] == T(0) ? Packet<T>{} : value[c] * corner.inverse[c];
            store<T>(columns + c * stride + i, value[c]);
        }
    }
    for (int c = 0; c < C; ++c)
        for (int r = 0; r < C; ++r) columns[c * stride + first + r] = corner.entry[c][r];
    return corner.lost;
}

// Solves with C columns of L, of which the first is column `first`, and subtracts their products
// from the rows below. Rows up to the next packet are treated one by one, because their packet
// holds rows above.
template <int C, class T>
void forward_columns(const T* panel, std::ptrdiff_t stride, int first, T* x) {
    const T* columns = panel + first * stride;
    std::array<T, C> value;
    for (int c = 0; c < C; ++c) {
        value[c] = x[first + c];
        for (int p = 0; p < c; ++p) value[c] -= columns[p * stride + first + c] * value[p];
        value[c] /= columns[c * stride + first + c];
        x[first + c] = value[c];
    }
    std::ptrdiff_t i = first + C;
    for (; i < stride && i % lanes<T> != 0; ++i)
        for (int c = 0; c < C; ++c) x[i] -= columns[c * stride + i] * value[c];
    for (; i < stride; i += lanes<T>) {
        Packet<T> left = load<T>(x + i);
        for (int c = 0; c < C; ++c) left -= load<T>(columns + c * stride + i) * value[c];
        store<T>(x + i, left);
    }
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
        const std::ptrdiff_t top = packet_of<T>(j);
        const auto subtract = [&](std::size_t begin, std::size_t end) {
            with_columns(columns, [&]<int C>() {
                subtract_rows<C>(panel + top + begin, panel + j, stride, j,
                                 panel + j * stride + top + begin, stride,
                                 static_cast<int>(end - begin));
            });
        };
        const auto rows = static_cast<std::size_t>(stride - top);
        if (j < deep)
            subtract(0, rows);
        else
            parallel_blocks(rows, shared_rows, subtract);
        with_columns(columns, [&]<int C>() {
            lost += eliminate_columns<C>(panel, stride, j, diagonal.data(), rule);
        });
    }
    if (rest == 0) return lost;
    const std::ptrdiff_t rest_stride = padded<T>(rest);
    const auto subtract = [&](std::size_t begin, std::size_t end) {
        for (int j = strip * static_cast<int>(begin);
             j < std::min(rest, strip * static_cast<int>(end)); j += strip) {
            throw_if_stopped(stop);
            const std::ptrdiff_t top = packet_of<T>(j);
            with_columns(std::min(strip, rest - j), [&]<int C>() {
                subtract_rows<C>(panel + pivots + top, panel + pivots + j, stride, pivots,
                                 remainder + j * rest_stride + top, rest_stride,
                                 static_cast<int>(rest_stride - top));
            });
        }
    };
    const auto strips = static_cast<std::size_t>((rest + strip - 1) / strip);
    if (pivots < deep)
        subtract(0, strips);
    else
        parallel_blocks(strips, shared_strips, subtract);
    return lost;
}

template <class T>
void forward_front(const T* panel, int pivots, int rest, T* x) {
    const std::ptrdiff_t stride = padded<T>(pivots + rest);
    for (int j = 0; j < pivots; j += strip)
        with_columns(std::min(strip, pivots - j),
                     [&]<int C>() { forward_columns<C>(panel, stride, j, x); });
}

template <class T>
void backward_front(const T* panel, int pivots, int rest, T* x) {
    const std::ptrdiff_t stride = padded<T>(pivots + rest);
    const T* below = x + pivots;
    for (int j = pivots - 1; j >= 0; --j) {
        const T* column = panel + j * stride;
        Packet<T> sums{};
        int i = 0;
        for (; i + lanes<T> <= rest; i += lanes<T>)
            sums += load<T>(column + pivots + i) * load<T>(below + i);
        T sum = sum_of<T>(sums);
        for (; i < rest; ++i) sum += column[pivots + i] * below[i];
        for (i = j + 1; i < pivots; ++i) sum += column[i] * x[i];
        x[j] = (x[j] - sum) / column[j];
    }
}

template int factor_front(double*, double*, int, int, PivotRule, const std::stop_token&);
template int factor_front(float*, float*, int, int, PivotRule, const std::stop_token&);
template void forward_front(const double*, int, int, double*);
template void forward_front(const float*, int, int, float*);
template void backward_front(const double*, int, int, double*);
template void backward_front(const float*, int, int, float*);

}  // namespace hepatica
