// SPDX-License-Identifier: GPL-3.0-or-later
// What a kernel is. Its work is cut into blocks of `threads` threads that share a few numbers; a
// barrier stands between its phases, so that a thread sees in one phase what the threads of its
// block wrote in the phase before. Blocks run in any order and know nothing of each other, and so
// do the threads of a block within a phase. Written so, one source runs as a CUDA kernel and, to
// the last bit the same, in two loops on the host (see emulator.h). A kernel has
//   static constexpr int threads, shared;             shared: numbers (double) of a block
//   int blocks() const, phases() const;
//   std::size_t bytes() const;                        see bytes_of
//   void operator()(int phase, int block, int thread, double* shared) const;
// and may go on alone in the block that ends last, which sees what all of them wrote:
//   int end_phases() const;
//   void end(int phase, int blocks, int thread, double* shared) const;
// A device can be asked to have room for so many of its blocks at once on each multiprocessor:
//   static constexpr int least_blocks;
#pragma once

#include <cstddef>
#include <type_traits>

#include "core/base/small_matrix.h"

namespace hepatica::gpu {

// The kernel that calls item(i) for every i in [0, item.count()): one thread an item.
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

// Whether the block that ends last goes on.
template <class Kernel>
constexpr bool has_end = detail::has_end<Kernel>;
template <class Kernel>
constexpr int least_blocks = detail::least_blocks<Kernel>;

template <class... Kernel>
struct KernelList {};

}  // namespace hepatica::gpu
