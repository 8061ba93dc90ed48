// SPDX-License-Identifier: GPL-3.0-or-later
// From elements to the system of eq. (12), as the paper has it: every element writes its forces and
// stiffness blocks into slots of its own, and every node and every nonzero block gathers from a
// list made once. Nothing is added up in an order that depends on threads.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/vector.h"
#include "core/deform/body.h"
#include "core/deform/element_slots.h"
#include "core/deform/solvers/block_matrix.h"

namespace hepatica {

// The slots of one body and the lists over them. Keeps a reference to the body. Not thread-safe.
class Assembly {
  public:
    explicit Assembly(const Body& body);

    // As ElementSlots.
    double evaluate(std::span<const Vec3> positions_mm, small::Tangent tangent) {
        return slots_.evaluate(positions_mm, tangent);
    }
    double energy(std::span<const Vec3> positions_mm) const { return slots_.energy(positions_mm); }
    double quadratic_form(std::span<const Vec3> d) const { return slots_.quadratic_form(d); }

    // Elastic force on each node, from the last evaluate [uN].
    void gather_forces(std::span<Vec3> forces_un) const;

    // Off-diagonal blocks of factor * K, diagonal blocks that make every row sum to zero.
    // `matrix` gets the pattern of `pattern()` if it does not have it.
    void gather_stiffness(double factor, BlockMatrix& matrix) const;

    // Rows, columns and zero blocks of the system matrix.
    const BlockMatrix& pattern() const { return pattern_; }

  private:
    void build_pattern();
    void build_gather_lists();

    const Body& body_;
    ElementSlots slots_;
    BlockMatrix pattern_;
    std::vector<int> mirror_;  // position of block (j, i) for every block (i, j)
    // Slots of node i: force_slot_[force_begin_[i]] ...
    std::vector<int> force_begin_;
    std::vector<int> force_slot_;
    // Slots of upper block k: those written from its row to its column from block_begin_[2 k] on,
    // those written the other way from block_begin_[2 k + 1].
    std::vector<int> block_begin_;
    std::vector<int> block_slot_;
};

}  // namespace hepatica
