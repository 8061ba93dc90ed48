// SPDX-License-Identifier: GPL-3.0-or-later
// Sums over nodes, in double and in a fixed order. Over all nodes in one kernel: blocks of threads
// sum chunks of nodes, and the last block sums the chunks. Over many segments, such as the pieces
// of a body: in one kernel where no segment is long, otherwise in two.
#pragma once

#include "gpu/kernels/view.h"

namespace hepatica::gpu {

constexpr int sum_threads = 128;
constexpr int nodes_per_chunk = sum_threads;

// The concept of a Term: static constexpr int width; std::size_t bytes() const;
//   void operator()(int node, double* sum) const   adds `width` numbers; may write node's values
// The concept of a Then: static constexpr int width;
//   void operator()(int segment, const double* sum) const   receives the sum
namespace detail {

// The sums of a block's threads are added up by this many threads per number, then by one.
constexpr int sum_lanes = 8;
constexpr int sum_phases = 4;
// Shared numbers of a block that this takes.
template <int Width>
constexpr int sum_shared = Width*(sum_threads + sum_lanes + 1);

// One phase of a sum over the threads of a block: put(sum) adds this thread's value, and in the
// last phase take(sum) receives the total.
template <int Width, class Put, class Take>
HEPATICA_HOST_DEVICE void sum_over_threads(int phase, int thread, double* shared, const Put& put,
                                           const Take& take) {
    static_assert(Width * sum_lanes <= sum_threads);
    double* const of_lane = shared + Width * sum_threads;
    double* const whole = of_lane + Width * sum_lanes;
    double sum[Width] = {};
    if (phase == 0) {
        put(sum);
        for (int k = 0; k < Width; ++k) shared[k * sum_threads + thread] = sum[k];
    } else if (phase == 1 && thread < Width * sum_lanes) {
        const double* const first = shared + thread / sum_lanes * sum_threads + thread % sum_lanes;
        for (int i = 0; i < sum_threads; i += sum_lanes) sum[0] += first[i];
        of_lane[thread] = sum[0];
    } else if (phase == 2 && thread < Width) {
        for (int lane = 0; lane < sum_lanes; ++lane) sum[0] += of_lane[thread * sum_lanes + lane];
        whole[thread] = sum[0];
    } else if (phase == 3 && thread == 0) {
        take(whole);
    }
}

// One phase of a sum over chunks [begin, end).
template <class Then>
HEPATICA_HOST_DEVICE void sum_chunks(int phase, int thread, double* shared,
                                     const View<const double>& partial, int begin, int end,
                                     int segment, const Then& then) {
    constexpr int width = Then::width;
    sum_over_threads<width>(
        phase, thread, shared,
        [&](double* sum) {
            for (int c = begin + thread; c < end; c += sum_threads)
                for (int k = 0; k < width; ++k) sum[k] += partial[c * width + k];
        },
        [&](const double* sum) { then(segment, sum); });
}

}  // namespace detail

// Calls a term for every node and discards its sums.
template <class Term>
struct Unsummed {
    Term term;
    int nodes;

    HEPATICA_HOST_DEVICE int count() const { return nodes; }
    std::size_t bytes() const { return term.bytes(); }
    HEPATICA_HOST_DEVICE void operator()(int i) const {
        double sum[Term::width] = {};
        term(i, sum);
    }
};

// Sum over all nodes.
template <class Term, class Then>
struct SumWhole {
    static constexpr int width = Term::width, threads = sum_threads,
                         shared = detail::sum_shared<width>;
    static_assert(width == Then::width);
    Term term;
    Then then;
    int nodes;
    View<double> partial;  // of each chunk, `width` numbers

    int blocks() const { return (nodes + nodes_per_chunk - 1) / nodes_per_chunk; }
    HEPATICA_HOST_DEVICE int phases() const { return detail::sum_phases; }
    HEPATICA_HOST_DEVICE int end_phases() const { return detail::sum_phases; }
    std::size_t bytes() const {
        return term.bytes() + 2 * static_cast<std::size_t>(blocks()) * width * sizeof(double);
    }
    HEPATICA_HOST_DEVICE void operator()(int phase, int chunk, int thread, double* sums) const {
        const int i = chunk * nodes_per_chunk + thread;
        detail::sum_over_threads<width>(
            phase, thread, sums,
            [&](double* sum) {
                if (i < nodes) term(i, sum);
            },
            [&](const double* sum) {
                for (int k = 0; k < width; ++k) partial[chunk * width + k] = sum[k];
            });
    }
    HEPATICA_HOST_DEVICE void end(int phase, int chunks, int thread, double* sums) const {
        detail::sum_chunks(phase, thread, sums, partial, 0, chunks, 0, then);
    }
};

// Division of the nodes into segments, and of segments into chunks.
struct PartitionView {
    View<const int> order;        // nodes by segment; empty: 0, 1, 2, ...
    View<const int> chunk_begin;  // first place of each chunk in the order, and the end of the last
    View<const int> segment_begin;  // first chunk of each segment, and the end of the last

    HEPATICA_HOST_DEVICE int chunks() const { return chunk_begin.size - 1; }
    HEPATICA_HOST_DEVICE int segments() const { return segment_begin.size - 1; }
    // One phase of a sum of the term over places [begin, end), of any number.
    template <class Term, class Take>
    HEPATICA_HOST_DEVICE void sum_places(int phase, int thread, double* shared, const Term& term,
                                         int begin, int end, const Take& take) const {
        detail::sum_over_threads<Term::width>(
            phase, thread, shared,
            [&](double* sum) {
                for (int k = begin + thread; k < end; k += sum_threads)
                    term(order.empty() ? k : order[k], sum);
            },
            take);
    }
};

// First of two kernels: sums chunks.
template <class Term>
struct SumChunks {
    static constexpr int threads = sum_threads, shared = detail::sum_shared<Term::width>;
    Term term;
    PartitionView partition;
    View<double> partial;  // of each chunk, `width` numbers

    int blocks() const { return partition.chunks(); }
    HEPATICA_HOST_DEVICE int phases() const { return detail::sum_phases; }
    std::size_t bytes() const {
        return term.bytes() + bytes_of(partition.order) +
               static_cast<std::size_t>(blocks()) * Term::width * sizeof(double);
    }
    HEPATICA_HOST_DEVICE void operator()(int phase, int chunk, int thread, double* sums) const {
        partition.sum_places(phase, thread, sums, term, partition.chunk_begin[chunk],
                             partition.chunk_begin[chunk + 1], [&](const double* sum) {
                                 for (int k = 0; k < Term::width; ++k)
                                     partial[chunk * Term::width + k] = sum[k];
                             });
    }
};

// Second of two kernels: sums the chunks of each segment.
template <class Then>
struct FinishSum {
    static constexpr int threads = sum_threads, shared = detail::sum_shared<Then::width>;
    Then then;
    PartitionView partition;
    View<const double> partial;

    int blocks() const { return partition.segments(); }
    HEPATICA_HOST_DEVICE int phases() const { return detail::sum_phases; }
    std::size_t bytes() const {
        return static_cast<std::size_t>(partition.chunks()) * Then::width * sizeof(double);
    }
    HEPATICA_HOST_DEVICE void operator()(int phase, int segment, int thread, double* sums) const {
        detail::sum_chunks(phase, thread, sums, partial, partition.segment_begin[segment],
                           partition.segment_begin[segment + 1], segment, then);
    }
};

// One kernel for both where no segment is long: one block of threads per segment.
template <class Term, class Then>
struct SumSegments {
    static constexpr int threads = sum_threads, shared = detail::sum_shared<Term::width>;
    static_assert(Term::width == Then::width);
    Term term;
    Then then;
    PartitionView partition;

    int blocks() const { return partition.segments(); }
    HEPATICA_HOST_DEVICE int phases() const { return detail::sum_phases; }
    std::size_t bytes() const { return term.bytes() + bytes_of(partition.order); }
    HEPATICA_HOST_DEVICE void operator()(int phase, int segment, int thread, double* sums) const {
        partition.sum_places(phase, thread, sums, term,
                             partition.chunk_begin[partition.segment_begin[segment]],
                             partition.chunk_begin[partition.segment_begin[segment + 1]],
                             [&](const double* sum) { then(segment, sum); });
    }
};

// Stores the sums of each segment for the host.
template <int Width>
struct KeepSums {
    static constexpr int width = Width;
    View<double> result;
    HEPATICA_HOST_DEVICE void operator()(int segment, const double* sum) const {
        for (int k = 0; k < Width; ++k) result[segment * Width + k] = sum[k];
    }
};

}  // namespace hepatica::gpu
