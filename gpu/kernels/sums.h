// SPDX-License-Identifier: GPL-3.0-or-later
// Sums over nodes, in double and in a fixed order, in two kernels: one adds up chunks of nodes, the
// other the chunks of each segment (all nodes, or the pieces of a body).
#pragma once

#include "gpu/kernels/view.h"

namespace hepatica::gpu {

// Which nodes are added up together.
struct PartitionView {
    View<const int> order;          // nodes by segment; empty: 0, 1, 2, ...
    View<const int> chunk_begin;    // places in the order, and the end of the last chunk
    View<const int> segment_begin;  // chunks, and the end of the last segment

    HEPATICA_HOST_DEVICE int chunks() const { return chunk_begin.size - 1; }
    HEPATICA_HOST_DEVICE int segments() const { return segment_begin.size - 1; }
};

constexpr int sum_threads = 128;  // a power of two
constexpr int nodes_per_chunk = sum_threads;

namespace detail {

// Adds up shared[k * sum_threads ...] by halves: phases 1 to 7 after every thread has put its own.
template <int Width>
HEPATICA_HOST_DEVICE void add_by_halves(int phase, int thread, double* shared) {
    const int half = sum_threads >> phase;
    for (int k = 0; k < Width && thread < half; ++k)
        shared[k * sum_threads + thread] += shared[k * sum_threads + thread + half];
}
inline constexpr int halvings = 7;
static_assert(1 << halvings == sum_threads);

}  // namespace detail

// Term: static constexpr int width; std::size_t bytes() const;
//   void operator()(int node, double* sum) const   adds `width` numbers; may write node's values
template <class Term>
struct SumChunks {
    static constexpr int threads = sum_threads, shared = Term::width * sum_threads;
    Term term;
    PartitionView partition;
    View<double> partial;  // of each chunk, `width` numbers

    int blocks() const { return partition.chunks(); }
    HEPATICA_HOST_DEVICE int phases() const { return 2 + detail::halvings; }
    std::size_t bytes() const {
        return term.bytes() + bytes_of(partition.order) +
               static_cast<std::size_t>(blocks()) * Term::width * sizeof(double);
    }
    HEPATICA_HOST_DEVICE void operator()(int phase, int chunk, int thread, double* sums) const {
        constexpr int width = Term::width;
        if (phase == 0) {
            double sum[width] = {};
            for (int k = partition.chunk_begin[chunk] + thread;
                 k < partition.chunk_begin[chunk + 1]; k += threads)
                term(partition.order.empty() ? k : partition.order[k], sum);
            for (int k = 0; k < width; ++k) sums[k * threads + thread] = sum[k];
        } else if (phase <= detail::halvings) {
            detail::add_by_halves<width>(phase, thread, sums);
        } else if (thread < width) {
            partial[chunk * width + thread] = sums[thread * threads];
        }
    }
};

// Then: static constexpr int width; void operator()(int segment, const double* sum) const
template <class Then>
struct FinishSum {
    static constexpr int threads = sum_threads, shared = Then::width * sum_threads;
    Then then;
    PartitionView partition;
    View<const double> partial;

    int blocks() const { return partition.segments(); }
    HEPATICA_HOST_DEVICE int phases() const { return 2 + detail::halvings; }
    std::size_t bytes() const {
        return static_cast<std::size_t>(partition.chunks()) * Then::width * sizeof(double);
    }
    HEPATICA_HOST_DEVICE void operator()(int phase, int segment, int thread, double* sums) const {
        constexpr int width = Then::width;
        if (phase == 0) {
            double sum[width] = {};
            for (int c = partition.segment_begin[segment] + thread;
                 c < partition.segment_begin[segment + 1]; c += threads)
                for (int k = 0; k < width; ++k) sum[k] += partial[c * width + k];
            for (int k = 0; k < width; ++k) sums[k * threads + thread] = sum[k];
        } else if (phase <= detail::halvings) {
            detail::add_by_halves<width>(phase, thread, sums);
        } else if (thread == 0) {
            double sum[width];
            for (int k = 0; k < width; ++k) sum[k] = sums[k * threads];
            then(segment, sum);
        }
    }
};

// Both at once where no segment is long: one block of threads a segment.
template <class Term, class Then>
struct SumSegments {
    static constexpr int threads = sum_threads, shared = Term::width * sum_threads;
    static_assert(Term::width == Then::width);
    Term term;
    Then then;
    PartitionView partition;

    int blocks() const { return partition.segments(); }
    HEPATICA_HOST_DEVICE int phases() const { return 2 + detail::halvings; }
    std::size_t bytes() const { return term.bytes() + bytes_of(partition.order); }
    HEPATICA_HOST_DEVICE void operator()(int phase, int segment, int thread, double* sums) const {
        constexpr int width = Term::width;
        if (phase == 0) {
            double sum[width] = {};
            const int end = partition.chunk_begin[partition.segment_begin[segment + 1]];
            for (int k = partition.chunk_begin[partition.segment_begin[segment]] + thread; k < end;
                 k += threads)
                term(partition.order.empty() ? k : partition.order[k], sum);
            for (int k = 0; k < width; ++k) sums[k * threads + thread] = sum[k];
        } else if (phase <= detail::halvings) {
            detail::add_by_halves<width>(phase, thread, sums);
        } else if (thread == 0) {
            double sum[width];
            for (int k = 0; k < width; ++k) sum[k] = sums[k * threads];
            then(segment, sum);
        }
    }
};

// Leaves the sums of each segment where the host finds them.
template <int Width>
struct KeepSums {
    static constexpr int width = Width;
    View<double> result;
    HEPATICA_HOST_DEVICE void operator()(int segment, const double* sum) const {
        for (int k = 0; k < Width; ++k) result[segment * Width + k] = sum[k];
    }
};

}  // namespace hepatica::gpu
