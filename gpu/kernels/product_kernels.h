// SPDX-License-Identifier: GPL-3.0-or-later
// Products of the matrix with a vector. A block of threads has a chunk of rows: in the first phase
// its threads are the blocks of the matrix in memory order, so that neighbours read neighbouring
// numbers; in the second they are rows, each of which adds up its own products.
#pragma once

#include <cstring>

#include "gpu/kernels/sums.h"
#include "gpu/kernels/system_kernels.h"

namespace hepatica::gpu {

// The concept of a Row: static constexpr int width; std::size_t bytes() const;
//   void operator()(int i, const Vector3<V>& row, const Vector3<V>& own, double* sum) const
// receives row = (A p)_i and own = p_i, and adds `width` numbers that are summed over all rows, as
// in SumWhole.
template <class Real, class Field, class Row, class Then>
struct SumRows {
    using V = NumberOf<Field>;
    static constexpr int rows = RowChunksView::most_rows, entries = RowChunksView::most_entries;
    static constexpr int width = Row::width, threads = 256, least_blocks = 5;
    static_assert(width == Then::width && 3 * rows <= threads && sum_threads <= threads);
    // Numbers of type V that entries, and then rows, share.
    static constexpr int of_entries = 3 * entries, of_rows = 3 * rows;
    static constexpr int common = (of_entries + of_rows) * int(sizeof(V)) / int(sizeof(double));
    static constexpr int shared = common + detail::sum_shared<width>;
    SystemView<Real> system;
    Field p;
    Row row;
    Then then;
    View<double> partial;  // `width` numbers for each chunk

    int blocks() const { return system.chunks.chunks(); }
    HEPATICA_HOST_DEVICE int phases() const { return 2 + detail::sum_phases; }
    HEPATICA_HOST_DEVICE int end_phases() const { return detail::sum_phases; }
    std::size_t bytes() const {
        return system.bytes() + bytes_of(p) + row.bytes() +
               2 * static_cast<std::size_t>(blocks()) * width * sizeof(double);
    }
    HEPATICA_HOST_DEVICE void operator()(int phase, int chunk, int thread, double* memory) const {
        const int first = system.chunks.begin[chunk], past = system.chunks.begin[chunk + 1];
        if (phase == 0)
            multiply(chunk, first, thread, memory);
        else if (phase == 1)
            add_up(chunk, first, past, thread, memory);
        else if (thread < sum_threads)
            detail::sum_over_threads<width>(
                phase - 2, thread, memory + common,
                [&](double* sum) {
                    if (first + thread < past) finish(first + thread, thread, memory, sum);
                },
                [&](const double* sum) {
                    for (int k = 0; k < width; ++k) partial[chunk * width + k] = sum[k];
                });
    }
    HEPATICA_HOST_DEVICE void end(int phase, int chunks, int thread, double* memory) const {
        if (thread < sum_threads)
            detail::sum_chunks(phase, thread, memory, partial, 0, chunks, 0, then);
    }

  private:
    static HEPATICA_HOST_DEVICE void keep(double* memory, int place, V value) {
        memcpy(reinterpret_cast<char*>(memory) + place * sizeof(V), &value, sizeof(V));
    }
    static HEPATICA_HOST_DEVICE V kept(const double* memory, int place) {
        V value;
        memcpy(&value, reinterpret_cast<const char*>(memory) + place * sizeof(V), sizeof(V));
        return value;
    }
    HEPATICA_HOST_DEVICE int entries_of(int chunk) const {
        return system.chunks.entry[chunk + 1] - system.chunks.entry[chunk];
    }
    // A_ij (p_j - p_i) of entry k.
    HEPATICA_HOST_DEVICE Vector3<V> product(int first, int k) const {
        return system.difference(k, first + system.chunks.row_of[k], p);
    }
    HEPATICA_HOST_DEVICE void multiply(int chunk, int first, int thread, double* memory) const {
        const int begin = system.chunks.entry[chunk], count = entries_of(chunk);
        if (count > entries) return;
        // Two entries at once halve the time that a thread waits for its loads.
        for (int e = thread; e < count; e += 2 * threads) {
            const int next = e + threads < count ? e + threads : e;
            const Vector3<V> one = product(first, begin + e);
            const Vector3<V> other = product(first, begin + next);
            for (int c = 0; c < 3; ++c) keep(memory, c * entries + e, one[c]);
            for (int c = 0; c < 3 && next > e; ++c) keep(memory, c * entries + next, other[c]);
        }
    }
    // A thread is a row and one of its three components.
    HEPATICA_HOST_DEVICE void add_up(int chunk, int first, int past, int thread,
                                     double* memory) const {
        const int c = thread / rows, i = first + thread % rows;
        if (c >= 3 || i >= past) return;
        const int begin = system.chunks.entry[chunk];
        const bool together = entries_of(chunk) <= entries;
        V sum = V(0);
        for (int k = system.row_begin[i]; k < system.row_begin[i + 1]; ++k)
            sum += together ? kept(memory, c * entries + k - begin) : system.difference(k, i, p)[c];
        keep(memory, of_entries + thread, sum);
    }
    HEPATICA_HOST_DEVICE void finish(int i, int thread, const double* memory, double* sum) const {
        Vector3<V> differences;
        for (int c = 0; c < 3; ++c) differences[c] = kept(memory, of_entries + c * rows + thread);
        row(i, system.row(i, p, differences), vector_of(p[i]), sum);
    }
};

// y = A p; sums p . y.
template <class V>
struct KeepProduct {
    static constexpr int width = 1;
    View<Vector3<V>> y;

    std::size_t bytes() const { return bytes_of(y); }
    HEPATICA_HOST_DEVICE void operator()(int i, const Vector3<V>& row, const Vector3<V>& own,
                                         double* sum) const {
        y[i] = row;
        for (int c = 0; c < 3; ++c) sum[0] += double(own[c]) * double(row[c]);
    }
};

// r = b - A x; sums r . r.
struct KeepResidual {
    static constexpr int width = 1;
    View<const Vector3<double>> b;
    View<Vector3<double>> r;

    std::size_t bytes() const { return bytes_of(b, r); }
    HEPATICA_HOST_DEVICE void operator()(int i, const Vector3<double>& row, const Vector3<double>&,
                                         double* sum) const {
        r[i] = b[i] - row;
        sum[0] += small::dot(r[i], r[i]);
    }
};

}  // namespace hepatica::gpu
