// SPDX-License-Identifier: GPL-3.0-or-later
// Sums over segments of nodes on a machine, such as the pieces of a body.
#pragma once

#include <span>
#include <vector>

#include "gpu/kernels/sums.h"
#include "gpu/step/growing_array.h"

namespace hepatica::gpu {

class Partition {
  public:
    explicit Partition(Machine& machine)
        : machine_(machine),
          order_(machine),
          chunk_begin_(machine),
          segment_begin_(machine),
          partial_(machine),
          result_(machine) {}

    // Sets one segment for each piece 0, 1, ...; there are `pieces` of them, or more if higher ones
    // are named.
    void set(std::span<const int> piece_of_node, int pieces = 0);

    int segments() const { return static_cast<int>(segment_begin_.size()) - 1; }

    // Sums the term over each segment and passes the sums to `then` on the machine, in one launch
    // where no segment is long.
    template <class Term, class Then>
    void sum(const Term& term, const Then& then) const {
        static_assert(Term::width == Then::width && Term::width <= most_width);
        if (longest_ <= most_at_once)
            return machine_.launch(SumSegments<Term, Then>{term, then, view()});
        machine_.launch(SumChunks<Term>{term, view(), partial_.view()});
        machine_.launch(FinishSum<Then>{then, view(), partial_.read()});
    }
    // The same, read back: `width` numbers per segment. Waits for the machine.
    template <class Term>
    std::vector<double> read(const Term& term) const {
        sum(term, KeepSums<Term::width>{result_.view()});
        std::vector<double> sums(static_cast<std::size_t>(segments() * Term::width));
        machine_.download(sums.data(), result_.read().data, sums.size() * sizeof(double));
        return sums;
    }

  private:
    static constexpr int most_width = 12;
    static constexpr int most_at_once = 32 * sum_threads;  // nodes of a segment

    PartitionView view() const {
        return {order_.read(), chunk_begin_.read(), segment_begin_.read()};
    }

    Machine& machine_;
    int longest_ = 0;  // longest segment in nodes
    GrowingArray<int> order_, chunk_begin_, segment_begin_;
    GrowingArray<double> partial_, result_;
};

}  // namespace hepatica::gpu
