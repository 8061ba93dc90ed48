// SPDX-License-Identifier: GPL-3.0-or-later
// Blocks run by TBB, or by a pool of threads without it.
#include "core/base/parallel.h"

#include <algorithm>
#include <vector>

#ifdef HEPATICA_HAS_TBB
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/parallel_for.h>
#else
#include <atomic>
#include <condition_variable>
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

// Without TBB: on machines that lack it, and under the thread sanitizer, which cannot see how TBB
// synchronises its threads. Pool threads wait for loops that have blocks left; the results are the
// same.
namespace {

std::atomic<int>& most_threads() {
    static std::atomic<int> most{
        std::max(2, static_cast<int>(std::thread::hardware_concurrency()))};
    return most;
}

// Runs blocks in order until all are taken or one has thrown.
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

    bool all_taken() const { return next_ >= blocks_; }

    void rethrow() const {
        if (failure_) std::rethrow_exception(failure_);
    }

    int helpers = 0;  // threads that work on it; guarded by the mutex of Crew

  private:
    std::size_t blocks_;
    const std::function<void(std::size_t)>& run_;
    std::atomic<std::size_t> next_{0};
    std::mutex mutex_;
    std::exception_ptr failure_;
};

// A pool of threads that help with loops. The thread that begins a loop works on it too, and waits
// only for helpers that have already started on it, so loops may be nested.
class Crew {
  public:
    ~Crew() {
        {
            const std::scoped_lock lock(mutex_);
            ended_ = true;
        }
        opened_.notify_all();
    }

    void run(BlockQueue& queue, std::size_t blocks) {
        const int most = most_threads();
        const auto wanted = std::min(blocks, static_cast<std::size_t>(most)) - 1;
        if (wanted == 0) return queue.work();
        {
            const std::scoped_lock lock(mutex_);
            open_.push_back(&queue);
            while (threads_.size() + 1 < static_cast<std::size_t>(most))
                threads_.emplace_back([this] { help(); });
        }
        for (std::size_t h = 0; h < wanted; ++h) opened_.notify_one();
        queue.work();
        std::unique_lock lock(mutex_);
        std::erase(open_, &queue);
        left_.wait(lock, [&] { return queue.helpers == 0; });
    }

  private:
    BlockQueue* one_to_help() {
        for (BlockQueue* queue : open_)
            if (!queue->all_taken() && queue->helpers + 1 < most_threads()) return queue;
        return nullptr;
    }

    void help() {
        std::unique_lock lock(mutex_);
        for (;;) {
            BlockQueue* queue = nullptr;
            opened_.wait(lock, [&] { return ended_ || (queue = one_to_help()) != nullptr; });
            if (ended_) return;
            ++queue->helpers;
            lock.unlock();
            queue->work();
            lock.lock();
            if (--queue->helpers == 0) left_.notify_all();
        }
    }

    std::mutex mutex_;
    std::condition_variable opened_, left_;
    std::vector<BlockQueue*> open_;
    bool ended_ = false;
    std::vector<std::jthread> threads_;  // last member: joined before the others are destroyed
};

void run_blocks(std::size_t blocks, const std::function<void(std::size_t)>& run) {
    static Crew crew;
    BlockQueue queue(blocks, run);
    crew.run(queue, blocks);
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
