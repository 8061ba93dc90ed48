// SPDX-License-Identifier: GPL-3.0-or-later
// From elements to the system of eq. (12), as the paper has it: every element writes its forces and
// stiffness blocks into slots of its own, and every node and every nonzero block gathers from the
// lists of the plan. Nothing is added up in an order that depends on threads.
#pragma once

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
    // Keeps a reference to `live`, too; null: everything is.
    explicit Assembly(const Body& body, small::Tangent tangent = small::Tangent::rotated,
                      const LiveSet* live = nullptr);

    // As ElementSlots.
    double evaluate(std::span<const Vec3> positions_mm) { return slots_.evaluate(positions_mm); }
    double evaluate_forces(std::span<const Vec3> positions_mm) {
        return slots_.evaluate_forces(positions_mm);
    }
    double evaluate_all_forces(std::span<const Vec3> positions_mm) {
        return slots_.evaluate_all_forces(positions_mm);
    }
    double energy(std::span<const Vec3> positions_mm) const { return slots_.energy(positions_mm); }
    double quadratic_form(std::span<const Vec3> d) const { return slots_.quadratic_form(d); }
    void add_energy_by_piece(std::span<const int> piece_of_node,
                             std::span<double> energy_nj) const {
        slots_.add_energy_by_piece(piece_of_node, energy_nj);
    }

    // Elastic force on each live node, from the last evaluation [uN]; the others keep what they
    // have.
    void gather_forces(std::span<Vec3> forces_un) const;

    // Off-diagonal blocks of factor * K, diagonal blocks that make every row sum to zero, in the
    // rows of live elements; those of held nodes lack what is frozen. `matrix` gets the plan's
    // pattern if it does not have it, and zeros.
    void gather_stiffness(double factor, BlockMatrix& matrix) const;

    const AssemblyPlan& plan() const { return *plan_; }

    // Slots of their own over the same plan.
    Assembly with_own_slots() const { return Assembly(*this); }

  private:
    using Wide = ElementSlots::Wide;

    small::Matrix3<double> upper_block(int k) const;

    // visit(row) for every row of a live element.
    template <class Visit>
    void for_each_row(const Visit& visit) const;

    std::shared_ptr<const AssemblyPlan> plan_;
    const LiveSet* live_;
    ElementSlots slots_;
};

}  // namespace hepatica
