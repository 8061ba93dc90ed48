// SPDX-License-Identifier: GPL-3.0-or-later
// Sums over all nodes of a body on a machine, each in one launch. Not thread-safe.
#pragma once

#include <algorithm>
#include <array>

#include "gpu/kernels/product_kernels.h"
#include "gpu/kernels/sums.h"
#include "gpu/step/growing_array.h"

namespace hepatica::gpu {

class WholeSum {
  public:
    explicit WholeSum(Machine& machine)
        : machine_(machine), partial_(machine), result_(machine, most_width) {}

    // Sets the number of nodes, and of the chunks in which their rows are multiplied.
    void resize(std::size_t nodes, int row_chunks = 0) {
        nodes_ = static_cast<int>(nodes);
        partial_.resize(most_width * std::max((nodes + nodes_per_chunk - 1) / nodes_per_chunk,
                                              static_cast<std::size_t>(row_chunks)));
    }

    // Calls the term for every node and discards its sums.
    template <class Term>
    void apply(const Term& term) const {
        machine_.for_each(Unsummed<Term>{term, nodes_});
    }
    // Sums the term and passes its sums to `then` on the machine.
    template <class Term, class Then>
    void sum(const Term& term, const Then& then) const {
        static_assert(Term::width <= most_width);
        machine_.launch(SumWhole<Term, Then>{term, then, nodes_, partial_.view()});
    }
    // Multiplies the rows of the system by p, and passes the sums that `row` makes of them to
    // `then`.
    template <class Real, class Field, class Row, class Then>
    void rows(const SystemView<Real>& system, const Field& p, const Row& row,
              const Then& then) const {
        machine_.launch(SumRows<Real, Field, Row, Then>{system, p, row, then, partial_.view()});
    }
    // The same as sum() and rows(), read back. Both wait for the machine.
    template <class Term>
    std::array<double, Term::width> read(const Term& term) const {
        sum(term, KeepSums<Term::width>{result_.view()});
        return result<Term::width>();
    }
    template <class Real, class Field, class Row>
    std::array<double, Row::width> read_rows(const SystemView<Real>& system, const Field& p,
                                             const Row& row) const {
        rows(system, p, row, KeepSums<Row::width>{result_.view()});
        return result<Row::width>();
    }

  private:
    static constexpr int most_width = 3;

    template <std::size_t Width>
    std::array<double, Width> result() const {
        std::array<double, Width> sums;
        result_.download(sums);
        return sums;
    }

    Machine& machine_;
    int nodes_ = 0;
    GrowingArray<double> partial_;
    Array<double> result_;
};

}  // namespace hepatica::gpu
