// SPDX-License-Identifier: GPL-3.0-or-later
// Sums over all nodes of a body on a machine, each in one launch.
#pragma once

#include <array>

#include "gpu/kernels/sums.h"
#include "gpu/kernels/system_kernels.h"
#include "gpu/step/growing_array.h"

namespace hepatica::gpu {

class WholeSum {
  public:
    explicit WholeSum(Machine& machine)
        : machine_(machine), partial_(machine), result_(machine, most_width) {}

    void resize(std::size_t nodes) {
        nodes_ = static_cast<int>(nodes);
        partial_.resize(most_width * ((nodes + nodes_per_chunk - 1) / nodes_per_chunk));
    }

    // Calls the term for every node; its sums are lost.
    template <class Term>
    void apply(const Term& term) const {
        machine_.for_each(Unsummed<Term>{term, nodes_});
    }
    // Adds up the term and hands its sums to `then`, on the machine.
    template <class Term, class Then>
    void sum(const Term& term, const Then& then) const {
        static_assert(Term::width <= most_width);
        machine_.launch(SumWhole<Term, Then>{term, then, nodes_, partial_.view()});
    }
    // y = A p, and p . y to `then`.
    template <class Real, class V, class Then>
    void product(const SystemView<Real>& system, View<const Vector3<V>> p, View<Vector3<V>> y,
                 const Then& then) const {
        machine_.launch(SumProduct<Real, V, Then>{system, p, y, then, partial_.view()});
    }
    // The same, read back. Both wait for the machine.
    template <class Term>
    std::array<double, Term::width> read(const Term& term) const {
        sum(term, KeepSums<Term::width>{result_.view()});
        return result<Term::width>();
    }
    template <class Real>
    double read_product(const SystemView<Real>& system, View<const Vector3<double>> p,
                        View<Vector3<double>> y) const {
        product(system, p, y, KeepSums<1>{result_.view()});
        return result<1>()[0];
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
