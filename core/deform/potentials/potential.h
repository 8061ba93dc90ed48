// SPDX-License-Identifier: GPL-3.0-or-later
// What acts on a body from outside, as one of a list of potentials that enter the implicit step:
// each gives its energy, its force (minus the gradient), its stiffness and its term of the ledger.
// One virtual call a step and potential; loops over nodes lie inside.
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

    // Energy at the positions [nJ]. A potential without a zero of its own, such as weight, counts
    // from `reference_mm`, and so loses no digits where the two are near each other.
    virtual double energy(std::span<const Vec3> positions_mm,
                          std::span<const Vec3> reference_mm) const = 0;

    // Adds that energy of every node to the piece of the body it belongs to, piece_of_node[i]. What
    // spans several nodes counts for the piece of its first: see join_pieces.
    virtual void add_energy_by_piece(std::span<const Vec3> positions_mm,
                                     std::span<const Vec3> reference_mm,
                                     std::span<const int> piece_of_node,
                                     std::span<double> energy_nj) const = 0;

    // Adds the forces [uN].
    virtual void add_forces(std::span<const Vec3> positions_mm,
                            std::span<Vec3> forces_un) const = 0;

    // Told before stiffness is asked for: the sum of all forces on the body there, elastic and of
    // all potentials, from which a potential with a kink can tell on which side of it the iterate
    // will end. It holds until the next call or end_step().
    virtual void foresee(std::span<const Vec3> /*positions_mm*/,
                         std::span<const Vec3> /*forces_un*/) {}

    // Adds factor * stiffness [uN/mm], positive semidefinite. Pairs of nodes that have no block in
    // the matrix are lumped on the diagonal: stiffer in the step, the same at rest.
    virtual void add_stiffness(std::span<const Vec3> positions_mm, double factor,
                               BlockMatrix& matrix) const = 0;

    // Adds factor * (stiffness at the positions) d, lumped as in a matrix of this pattern.
    virtual void add_product(std::span<const Vec3> positions_mm, double factor,
                             std::span<const Vec3> d, const BlockMatrix& pattern,
                             std::span<Vec3> product) const = 0;

    // Stiffness between nodes that have no block in the matrix and is not lumped, either: the true
    // product is that of add_product and this one. `coupled` says whether there is any.
    virtual bool coupled(std::span<const Vec3> /*positions_mm*/) const { return false; }
    virtual void add_coupling(std::span<const Vec3> /*positions_mm*/, double /*factor*/,
                              std::span<const Vec3> /*d*/, std::span<Vec3> /*product*/) const {}
    // Appends its blocks.
    virtual void append_coupling(std::span<const Vec3> /*positions_mm*/, double /*factor*/,
                                 CouplingBlocks& /*blocks*/) const {}

    // Sets held[i] for the nodes that it ties to points in space: through these the body exchanges
    // momentum with its surroundings. Weight ties none.
    virtual void mark_held(std::span<const Vec3> /*positions_mm*/, std::span<char> /*held*/) const {
    }

    // Unites the pieces that it couples.
    virtual void join_pieces(std::span<const int> /*piece_of_node*/,
                             DisjointSets& /*pieces*/) const {}

    // A step of dt_s begins at the state `start`, or the part of one that is left; until end_step()
    // a potential may depend on it. Outside of a step nothing does. Nodes with held[i] != 0 stay
    // where they are, and their stiffness may be left out; `held` stays there until the end.
    virtual void begin_step(const BodyState& /*start*/, double /*dt_s*/,
                            std::span<const std::uint8_t> /*held*/) {}
    virtual void end_step() {}

    // The share of the straight motion of all nodes on which nothing passes through anything, with
    // room to spare; and the share of it after which something touches that did not. 1: all of it.
    virtual double free_share(std::span<const Vec3> /*from_mm*/,
                              std::span<const Vec3> /*to_mm*/) const {
        return 1.0;
    }
    virtual double share_until_touch(std::span<const Vec3> /*from_mm*/,
                                     std::span<const Vec3> /*to_mm*/) const {
        return 1.0;
    }

    // Writes `energy_nj` (with the start of the step as reference) into its term of the ledger, or
    // adds it to one that it shares and that was 0 before.
    virtual void book(double energy_nj, EnergyLedger& ledger) const = 0;
};

}  // namespace hepatica
