// SPDX-License-Identifier: GPL-3.0-or-later
// Assembles the system of eq. (12) from the elements, as in the paper: every element writes its
// forces and stiffness blocks into slots of its own, and every node and every nonzero block gathers
// from the lists of the plan. The order of summation does not depend on threads.
#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "core/base/vector.h"
#include "core/deform/body/body.h"
#include "core/deform/solvers/block_matrix.h"
#include "core/deform/step/assembly_plan.h"
#include "core/deform/step/element_slots.h"

namespace hepatica {

// The slots of one body. Keeps a reference to the body. Not thread-safe.
class Assembly {
  public:
    // Keeps a reference to `live`; null means that all elements are live.
    explicit Assembly(const Body& body, small::Tangent tangent = small::Tangent::rotated,
                      const LiveSet* live = nullptr);

    // See ElementSlots.
    double evaluate(std::span<const Vec3> positions_mm) { return slots_.evaluate(positions_mm); }
    double evaluate_forces(std::span<const Vec3> positions_mm) {
        return slots_.evaluate_forces(positions_mm);
    }
    double evaluate_all_forces(std::span<const Vec3> positions_mm) {
        return slots_.evaluate_all_forces(positions_mm);
    }
    double energy(std::span<const Vec3> positions_mm) const { return slots_.energy(positions_mm); }
    double quadratic_form(std::span<const Vec3> d) const { return slots_.quadratic_form(d); }
    void find_stress(std::vector<Mat3>& stress_pa, std::vector<double>& energy_nj) const {
        slots_.find_stress(stress_pa, energy_nj);
    }
    void add_energy_by_piece(std::span<const int> piece_of_node,
                             std::span<double> energy_nj) const {
        slots_.add_energy_by_piece(piece_of_node, energy_nj);
    }

    // Writes the elastic force [uN] of the last evaluation for each live node; entries of other
    // nodes are left unchanged.
    void gather_forces(std::span<Vec3> forces_un) const;

    // Writes factor * K into the rows of live elements: the off-diagonal blocks, and diagonal
    // blocks that make every row sum to zero. Rows of held nodes lack the contributions of frozen
    // elements. A `matrix` with another pattern first gets that of the plan, filled with zeros.
    void gather_stiffness(double factor, BlockMatrix& matrix) const;

    const AssemblyPlan& plan() const { return *plan_; }
    // To be called after the body's nodes were split; `before` is the body that the plan was made
    // for. The plan object and the contents of the slots are kept.
    void follow_split(const Body& before) { *plan_ = plan_after_split(*plan_, before, body_); }
    const ElementSlots& slots() const { return slots_; }

    // A copy with its own slots that shares the plan.
    Assembly with_own_slots() const { return Assembly(*this); }

  private:
    using Wide = ElementSlots::Wide;

    // A block above the diagonal and its transpose, by columns; the fourth lanes are not used.
    struct BlockPair {
        std::array<Wide, 3> upper, lower;
    };
    BlockPair upper_block(int k) const;

    // Number of the r-th row of a live element, in ascending order.
    int row(std::size_t r) const;
    // Calls visit(begin, end) for blocks of these rows.
    template <class Visit>
    void for_each_row_block(const Visit& visit) const;
    // The blocks of row i above the diagonal, and their mirrors in other rows.
    void gather_upper(int i, double factor, BlockMatrix& matrix) const;
    // What makes row i sum to zero; all other blocks of the row must be there.
    void gather_diagonal(int i, BlockMatrix& matrix) const;

    const Body& body_;
    std::shared_ptr<AssemblyPlan> plan_;
    const LiveSet* live_;
    ElementSlots slots_;
};

}  // namespace hepatica
