// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/parallel.h"

#include <algorithm>
#include <vector>

#ifdef HEPATICA_HAS_TBB
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/parallel_for.h>
#else
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#endif

namespace hepatica {

#ifdef HEPATICA_HAS_TBB

struct ThreadLimit::Implementation {
    explicit Implementation(int threads)
        : control(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads)) {
    }
    tbb::global_control control;
};

#else

// Without TBB: on machines that lack it, and under the thread sanitizer, which cannot see how TBB's
// own library orders its threads. Threads are started for each loop, which costs some 50
// microseconds; the order of the results is the same.
namespace {

std::atomic<int>& most_threads() {
    static std::atomic<int> most{
        std::max(2, static_cast<int>(std::thread::hardware_concurrency()))};
    return most;
}

// Takes blocks, the first that nobody has taken yet, until none is left or one has thrown.
class BlockQueue {
  public:
    BlockQueue(std::size_t blocks, const std::function<void(std::size_t)>& run)
        : blocks_(blocks), run_(run) {}

    void work() {
        for (std::size_t b = next_++; b < blocks_; b = next_++) {
            try {
                run_(b);
            } catch (...) {
                const std::scoped_lock lock(mutex_);
                if (!failure_) failure_ = std::current_exception();
                next_ = blocks_;
            }
        }
    }

    void rethrow() const {
        if (failure_) std::rethrow_exception(failure_);
    }

  private:
    std::size_t blocks_;
    const std::function<void(std::size_t)>& run_;
    std::atomic<std::size_t> next_{0};
    std::mutex mutex_;
    std::exception_ptr failure_;
};

void run_blocks(std::size_t blocks, const std::function<void(std::size_t)>& run) {
    BlockQueue queue(blocks, run);
    {
        std::vector<std::jthread> helpers;
        const auto helping = std::min(blocks, static_cast<std::size_t>(most_threads().load())) - 1;
        for (std::size_t h = 0; h < helping; ++h) helpers.emplace_back([&] { queue.work(); });
        queue.work();
    }
    queue.rethrow();
}

}  // namespace

struct ThreadLimit::Implementation {
    explicit Implementation(int threads) : before(most_threads().exchange(threads)) {}
    ~Implementation() { most_threads() = before; }
    int before;
};

#endif

ThreadLimit::ThreadLimit(int threads)
    : implementation_(std::make_unique<Implementation>(std::max(threads, 1))) {}
ThreadLimit::~ThreadLimit() = default;

void parallel_blocks(std::size_t count, std::size_t block,
                     const std::function<void(std::size_t, std::size_t)>& body) {
    const std::size_t blocks = (count + block - 1) / block;
    if (blocks == 0) return;
    const auto run = [&](std::size_t b) { body(b * block, std::min(count, (b + 1) * block)); };
    if (blocks == 1) return run(0);
#ifdef HEPATICA_HAS_TBB
    tbb::parallel_for(std::size_t{0}, blocks, run);
#else
    run_blocks(blocks, run);
#endif
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
