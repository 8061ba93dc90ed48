// SPDX-License-Identifier: GPL-3.0-or-later
// One external potential of a body; a list of them enters the implicit step. Each gives its energy,
// its force (minus the gradient), its stiffness and its term of the ledger. Loops over nodes are
// inside the virtual calls, so that dispatch costs one call per step and potential.
#pragma once

#include <cstdint>
#include <span>

#include "core/base/disjoint_sets.h"
#include "core/base/vector.h"
#include "core/deform/body/body_state.h"
#include "core/deform/body/energy_ledger.h"
#include "core/deform/solvers/block_matrix.h"
#include "core/deform/solvers/coupling_blocks.h"

namespace hepatica {

// All positions are in mm, one per node of the body. Const access from one thread at a time; loops
// inside run in parallel and give the same bits for any number of threads.
class Potential {
  public:
    Potential() = default;
    Potential(const Potential&) = delete;
    Potential& operator=(const Potential&) = delete;
    virtual ~Potential() = default;

    // Energy at the positions [nJ]. A potential without a natural zero, such as weight, counts from
    // `reference_mm`, which keeps digits where the two are near each other.
    virtual double energy(std::span<const Vec3> positions_mm,
                          std::span<const Vec3> reference_mm) const = 0;

    // Adds the same energy node by node to the piece of the body that the node belongs to,
    // piece_of_node[i]. An energy of several nodes counts for the piece of the first: see
    // join_pieces.
    virtual void add_energy_by_piece(std::span<const Vec3> positions_mm,
                                     std::span<const Vec3> reference_mm,
                                     std::span<const int> piece_of_node,
                                     std::span<double> energy_nj) const = 0;

    // Adds the forces [uN].
    virtual void add_forces(std::span<const Vec3> positions_mm,
                            std::span<Vec3> forces_un) const = 0;

    // Called before stiffness is asked for, with the sum of all forces on the body, elastic ones
    // and those of all potentials. From it a potential with a kink can tell on which side of the
    // kink the iterate will end. Valid until the next call or end_step().
    virtual void foresee(std::span<const Vec3> /*positions_mm*/,
                         std::span<const Vec3> /*forces_un*/) {}

    // Adds factor * stiffness [uN/mm], positive semidefinite. Where two nodes have no block in the
    // matrix, their stiffness is lumped on the diagonal: stiffer during the step, the same at rest.
    virtual void add_stiffness(std::span<const Vec3> positions_mm, double factor,
                               BlockMatrix& matrix) const = 0;

    // Adds factor * (stiffness at the positions) d, lumped as add_stiffness() lumps for this
    // pattern.
    virtual void add_product(std::span<const Vec3> positions_mm, double factor,
                             std::span<const Vec3> d, const BlockMatrix& pattern,
                             std::span<Vec3> product) const = 0;

    // Stiffness between nodes that have no block in the matrix, not lumped: the true product is the
    // sum of add_product and add_coupling. `coupled` says whether there is any.
    virtual bool coupled(std::span<const Vec3> /*positions_mm*/) const { return false; }
    virtual void add_coupling(std::span<const Vec3> /*positions_mm*/, double /*factor*/,
                              std::span<const Vec3> /*d*/, std::span<Vec3> /*product*/) const {}
    // Appends the blocks of the coupling.
    virtual void append_coupling(std::span<const Vec3> /*positions_mm*/, double /*factor*/,
                                 CouplingBlocks& /*blocks*/) const {}

    // Sets held[i] for the nodes that it ties to points in space: through them the body exchanges
    // momentum with its surroundings. Weight ties no nodes.
    virtual void mark_held(std::span<const Vec3> /*positions_mm*/, std::span<char> /*held*/) const {
    }

    // Unites the pieces that it couples.
    virtual void join_pieces(std::span<const int> /*piece_of_node*/,
                             DisjointSets& /*pieces*/) const {}

    // A step of dt_s, or the rest of one, begins at the state `start`; a potential may depend on it
    // until end_step(), but not outside of a step. Nodes with held[i] != 0 do not move, and their
    // stiffness may be left out; `held` must stay valid until end_step().
    virtual void begin_step(const BodyState& /*start*/, double /*dt_s*/,
                            std::span<const std::uint8_t> /*held*/) {}
    virtual void end_step() {}

    // free_share: the share of the straight motion of all nodes that passes through nothing, with a
    // margin. share_until_touch: the share after which a pair that did not touch before touches. 1:
    // the whole motion.
    virtual double free_share(std::span<const Vec3> /*from_mm*/,
                              std::span<const Vec3> /*to_mm*/) const {
        return 1.0;
    }
    virtual double share_until_touch(std::span<const Vec3> /*from_mm*/,
                                     std::span<const Vec3> /*to_mm*/) const {
        return 1.0;
    }

    // Writes `energy_nj` (relative to the start of the step) to its term of the ledger, or adds it
    // where several potentials share a term, which must then be 0 before the first.
    virtual void book(double energy_nj, EnergyLedger& ledger) const = 0;
};

}  // namespace hepatica
