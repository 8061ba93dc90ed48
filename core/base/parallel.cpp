// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/parallel.h"

#include <algorithm>
#include <vector>

#ifdef HEPATICA_HAS_TBB
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/parallel_for.h>
#endif

namespace hepatica {

#ifdef HEPATICA_HAS_TBB

struct ThreadLimit::Implementation {
    explicit Implementation(int threads)
        : control(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads)) {
    }
    tbb::global_control control;
};

#else  // the solver alone, on a machine without TBB: one thread

struct ThreadLimit::Implementation {
    explicit Implementation(int) {}
};

#endif

ThreadLimit::ThreadLimit(int threads)
    : implementation_(std::make_unique<Implementation>(std::max(threads, 1))) {}
ThreadLimit::~ThreadLimit() = default;

void parallel_blocks(std::size_t count, std::size_t block,
                     const std::function<void(std::size_t, std::size_t)>& body) {
    const std::size_t blocks = (count + block - 1) / block;
    const auto run = [&](std::size_t b) { body(b * block, std::min(count, (b + 1) * block)); };
#ifdef HEPATICA_HAS_TBB
    if (blocks > 1) {
        tbb::parallel_for(std::size_t{0}, blocks, run);
        return;
    }
#endif
    for (std::size_t b = 0; b < blocks; ++b) run(b);
}

double parallel_sum(std::size_t count, std::size_t block,
                    const std::function<double(std::size_t, std::size_t)>& block_sum) {
    std::vector<double> partial((count + block - 1) / block);
    parallel_blocks(count, block, [&](std::size_t begin, std::size_t end) {
        partial[begin / block] = block_sum(begin, end);
    });
    double sum = 0.0;
    for (const double p : partial) sum += p;
    return sum;
}

}  // namespace hepatica
