// SPDX-License-Identifier: GPL-3.0-or-later
// Parallel loops whose results do not depend on the number of threads: the range is divided into
// fixed blocks, and sums are added in the order of the blocks.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>

namespace hepatica {

// Calls body(begin, end) for consecutive blocks of `block` (> 0) indices that cover [0, count); the
// last may be shorter. Blocks run in any order, on any thread; their borders do not depend on the
// number of threads. An exception from a body is rethrown here once the running blocks have ended.
// Loops may be nested.
void parallel_blocks(std::size_t count, std::size_t block,
                     const std::function<void(std::size_t begin, std::size_t end)>& body);

// Sum over blocks of block_sum(begin, end), added in the order of the blocks: bitwise equal for any
// number of threads.
double parallel_sum(std::size_t count, std::size_t block,
                    const std::function<double(std::size_t begin, std::size_t end)>& block_sum);

// During its lifetime at most `threads` threads (1 or more) take part in the loops above.
class ThreadLimit {
  public:
    explicit ThreadLimit(int threads);
    ~ThreadLimit();
    ThreadLimit(const ThreadLimit&) = delete;
    ThreadLimit& operator=(const ThreadLimit&) = delete;

  private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation_;
};

}  // namespace hepatica
