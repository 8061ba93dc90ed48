// SPDX-License-Identifier: GPL-3.0-or-later
// From elements to the system of eq. (12), as the paper has it: every element writes its forces and
// stiffness blocks into slots of its own, and every node and every nonzero block gathers from a
// list made once. Nothing is added up in an order that depends on threads.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/base/vector.h"
#include "core/deform/body/body.h"
#include "core/deform/solvers/block_matrix.h"
#include "core/deform/step/element_slots.h"

namespace hepatica {

// The slots of one body and the lists over them. Keeps a reference to the body. Not thread-safe.
class Assembly {
  public:
    explicit Assembly(const Body& body, small::Tangent tangent = small::Tangent::rotated);

    // As ElementSlots.
    double evaluate(std::span<const Vec3> positions_mm) { return slots_.evaluate(positions_mm); }
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
    using Wide = ElementSlots::Wide;
    // Lists over the slots: that of entry k is place[begin[k]] ... place[begin[k + 1]].
    struct Contributions {
        std::vector<int> begin{0};
        std::vector<int> place;
    };

    static Contributions by_entry(std::size_t entries,
                                  const std::vector<std::array<int, 2>>& pairs);
    small::Matrix3<double> upper_block(int k) const;
    void build_pattern();
    void build_gather_lists();

    const Body& body_;
    ElementSlots slots_;
    BlockMatrix pattern_;
    std::vector<int> mirror_;  // position of block (j, i) for every block (i, j)
    Contributions forces_;     // slots, of each node
    Contributions factors_;  // of each upper block: two turned gradients, of its row and its column
    Contributions blocks_;   // of each upper block: slots of blocks as they were written,
    Contributions transposed_;  // and to be transposed
};

}  // namespace hepatica
