// SPDX-License-Identifier: GPL-3.0-or-later
// Removes spurious energy by scaling velocities, one connected piece of the body at a time: a
// linearised step may make energy where elements turn far. A piece that nothing holds keeps its
// linear and angular momentum: only its motion relative to the rigid one about its centre of mass
// is scaled. A piece that is held (fixed vertices, tissue, a grab) has no momentum of its own and
// is scaled as a whole. Pieces that share no grab do not feel each other, and one that rests is
// left alone.
#pragma once

#include <span>
#include <vector>

#include "core/deform/body/body.h"
#include "core/deform/body/body_state.h"
#include "core/deform/step/assembly.h"
#include "core/deform/step/step_report.h"
#include "core/deform/step/step_underway.h"

namespace hepatica {

// What was left to give where a piece's deforming motion had less energy than was asked for.
enum class MomentumLost { none, angular, linear };

// Takes `energy_nj` >= 0 of kinetic energy from the nodes of one piece: of its deforming motion
// first; if that is not enough, of its spin; at last of its flight, since no energy may be made.
// Momentum is exact to rounding where the answer is `none`. A held piece is scaled about rest and
// answers `none`.
MomentumLost take_kinetic_energy(std::span<const int> nodes, std::span<const double> mass_g,
                                 std::span<const Vec3> positions_mm, bool held, double energy_nj,
                                 std::vector<Vec3>& velocities_mm_per_s);

// Keeps a reference to the body. Not thread-safe. Energies by piece are summed up only where the
// body has several.
class EnergyLimiter {
  public:
    EnergyLimiter(const Body& body, const AssemblyPlan& plan);

    // Takes down the energies at the start of a step; the assembly's slots are of that state.
    void begin(const StepUnderway& step, const Assembly& assembly);

    // Nodes of pieces that share their energy, of which the step made more than their motion may
    // give back: of one that flies free the deforming motion, else all of it. Also of one that
    // flies free and lost its momentum.
    struct Overdrawn {
        std::vector<int> nodes;
        bool flies = false;  // one piece that nothing holds
    };
    // The assembly's slots are of the end of the step. Empty where the body is one piece. The
    // energies that it sums up serve limit(), unless forget_end() says that the step's end changed.
    std::vector<Overdrawn> overdrawn(const StepUnderway& step, const Assembly& assembly,
                                     std::span<const std::uint8_t> held);
    void forget_end() { after_.clear(); }
    // The same for a step whose energies by piece were summed up elsewhere, see limit().
    struct Balance {
        double energy = 0.0;   // of all kinds
        double kinetic = 0.0;  // of it
    };
    std::vector<Overdrawn> overdrawn(const StepUnderway& step, std::span<const Balance> before,
                                     std::span<const Balance> after,
                                     std::span<const std::uint8_t> held) const;

    // The velocity at the end of the step of a piece that nothing but weight and drag acts on.
    Vec3 flight(const StepUnderway& step, const Vec3& before_mm_per_s) const;

    struct Outcome {
        bool limited = false;
        MomentumLost lost = MomentumLost::none;
    };
    // Limits `velocities`, those at the end of the step, so that no piece has more energy than it
    // began with and weight gave it. `after` are the body's energies at the end; the assembly's
    // slots are of that state. held[i] != 0: the node is fixed or frozen.
    Outcome limit(const StepUnderway& step, const EnergyLedger& after, const Assembly& assembly,
                  std::span<const std::uint8_t> held, std::vector<Vec3>& velocities_mm_per_s) const;

    // The same for a step whose energies by piece were summed up elsewhere, one entry per piece:
    // all that is stored at the start, and at the end less the work of weight. An excess below
    // `rounding` of the energies plus `least_nj` means nothing. Elements and contacts take no part
    // in it.
    struct Pieces {
        std::span<const Balance> before, after;
        double rounding = 1e-9;
        double least_nj = 0.0;
        bool together = false;  // see StepUnderway
    };
    Outcome limit(const Pieces& pieces, const PotentialList& potentials,
                  std::span<const Vec3> positions_mm, std::span<const std::uint8_t> held,
                  std::vector<Vec3>& velocities_mm_per_s) const;

    int pieces() const { return static_cast<int>(nodes_.size()); }
    std::span<const int> piece_of_node() const { return piece_of_node_; }

  private:
    bool brakes(const StepUnderway& step, std::span<const int> nodes, double excess_nj) const;
    // Pieces that share their energy, ascending; each piece belongs to one group.
    std::vector<std::vector<int>> coupled_pieces(const PotentialList& potentials,
                                                 bool together) const;
    std::vector<Balance> balance(const StepUnderway& step, std::span<const Vec3> positions_mm,
                                 std::span<const Vec3> velocities_mm_per_s,
                                 const Assembly& assembly) const;

    const Body& body_;
    std::vector<int> piece_of_node_;
    std::vector<std::vector<int>> nodes_;  // of each piece
    std::vector<double> mass_g_;           // likewise
    std::vector<Balance> before_;
    std::vector<Balance> after_;  // of the step's end; empty: not summed up
};

// Says in the report of a step what the limiter took, after which `kinetic_nj` is left.
void book(const EnergyLimiter::Outcome& outcome, double kinetic_nj, StepReport& report);

}  // namespace hepatica
