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
#include "core/deform/solvers/block_matrix.h"

namespace hepatica {

// The slots of one body and the lists over them. Keeps a reference to the body. Not thread-safe.
class Assembly {
  public:
    explicit Assembly(const Body& body);

    // Evaluates all elements at the positions; returns the elastic energy [nJ]. With
    // Tangent::none only forces are written, otherwise forces and stiffness.
    double evaluate(std::span<const Vec3> positions_mm, small::Tangent tangent);
    // The elastic energy alone; leaves the slots as they are.
    double energy(std::span<const Vec3> positions_mm) const;

    // Elastic force on each node, from the last evaluate [uN].
    void gather_forces(std::span<Vec3> forces_un) const;

    // Off-diagonal blocks of factor * K, diagonal blocks that make every row sum to zero.
    // `matrix` gets the pattern of `pattern()` if it does not have it.
    void gather_stiffness(double factor, BlockMatrix& matrix) const;

    // d^T K d over the elements' slots and differences of d, independent of any matrix.
    double quadratic_form(std::span<const Vec3> d) const;

    // Rows, columns and zero blocks of the system matrix.
    const BlockMatrix& pattern() const { return pattern_; }

  private:
    struct GroupSlots {
        std::size_t first_force = 0;
        std::size_t first_block = 0;
    };

    void build_pattern();
    void build_gather_lists();

    const Body& body_;
    std::vector<GroupSlots> slots_;
    std::vector<small::Vector3<double>> element_force_;
    std::vector<small::Matrix3<double>> element_block_;
    BlockMatrix pattern_;
    std::vector<int> mirror_;  // position of block (j, i) for every block (i, j)
    // Slots of node i: force_slot_[force_begin_[i]] ...
    std::vector<int> force_begin_;
    std::vector<int> force_slot_;
    // Slots of upper block k.
    std::vector<int> block_begin_;
    std::vector<int> block_slot_;
};

}  // namespace hepatica
