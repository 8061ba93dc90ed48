// SPDX-License-Identifier: GPL-3.0-or-later
// The concept of a kernel. Its work is divided into blocks of `threads` threads that share a few
// numbers. A barrier separates its phases, so that in each phase a thread sees what the threads of
// its block wrote in the phase before. Blocks run in any order and independently of each other, and
// so do the threads of a block within a phase. Thus one source runs both as a CUDA kernel and, with
// bitwise equal results, in two loops on the host (see emulator.h). A kernel has
//   static constexpr int threads, shared;             shared: numbers (double) of a block
//   int blocks() const, phases() const;
//   std::size_t bytes() const;                        see bytes_of
//   void operator()(int phase, int block, int thread, double* shared) const;
// and optionally a continuation in the block that ends last, which sees what all of them wrote:
//   int end_phases() const;
//   void end(int phase, int blocks, int thread, double* shared) const;
// and optionally the least number of blocks that each multiprocessor should hold at once:
//   static constexpr int least_blocks;
#pragma once

#include <cstddef>
#include <type_traits>

#include "core/base/small_matrix.h"

namespace hepatica::gpu {

// Kernel that calls item(i) for every i in [0, item.count()), one thread per item.
template <class Item>
struct ForEach {
    static constexpr int threads = 128, shared = 1;
    Item item;

    int blocks() const { return (item.count() + threads - 1) / threads; }
    HEPATICA_HOST_DEVICE int phases() const { return 1; }
    std::size_t bytes() const { return item.bytes(); }
    HEPATICA_HOST_DEVICE void operator()(int, int block, int thread, double*) const {
        const int i = block * threads + thread;
        if (i < item.count()) item(i);
    }
};

namespace detail {

template <class Kernel, class = void>
constexpr bool has_end = false;
template <class Kernel>
constexpr bool has_end<Kernel, std::void_t<decltype(&Kernel::end)>> = true;

template <class Kernel, class = void>
constexpr int least_blocks = 1;
template <class Kernel>
constexpr int least_blocks<Kernel, std::void_t<decltype(Kernel::least_blocks)>> =
    Kernel::least_blocks;

}  // namespace detail

// Whether the kernel has a continuation in the block that ends last.
template <class Kernel>
constexpr bool has_end = detail::has_end<Kernel>;
template <class Kernel>
constexpr int least_blocks = detail::least_blocks<Kernel>;

template <class... Kernel>
struct KernelList {};

}  // namespace hepatica::gpu
