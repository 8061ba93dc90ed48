// SPDX-License-Identifier: GPL-3.0-or-later
// Loops over several threads whose results do not depend on how many there are: the range is cut
// into fixed blocks, and sums are added up block by block in order.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>

namespace hepatica {

// Calls body(begin, end) for consecutive blocks of `block` indices (the last may be shorter) that
// cover [0, count). Blocks run in any order, on any thread; their borders never depend on the
// number of threads. An exception from a body is rethrown here after the others have stopped.
void parallel_blocks(std::size_t count, std::size_t block,
                     const std::function<void(std::size_t begin, std::size_t end)>& body);

// Sum over blocks of block_sum(begin, end), added in the order of the blocks: the same bits for any
// number of threads.
double parallel_sum(std::size_t count, std::size_t block,
                    const std::function<double(std::size_t begin, std::size_t end)>& block_sum);

// While it lives, at most `threads` threads (1 or more) take part in the loops above.
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
