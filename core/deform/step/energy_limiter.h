// SPDX-License-Identifier: GPL-3.0-or-later
// Removes spurious energy by scaling velocities, one connected piece of the body at a time, because
// a linearised step may create energy where elements rotate far. A free piece keeps its linear and
// angular momentum: only the deviation of its velocities from the rigid motion about its centre of
// mass is scaled. A piece that is held (by fixed vertices, tissue, a grab or contact with what
// stands) exchanges momentum with its surroundings and is scaled as a whole. Pieces are independent
// unless a potential couples them, and a piece at rest is left alone.
#pragma once

#include <span>
#include <vector>

#include "core/deform/body/body.h"
#include "core/deform/body/body_state.h"
#include "core/deform/step/assembly.h"
#include "core/deform/step/step_report.h"
#include "core/deform/step/step_underway.h"

namespace hepatica {

// Which momentum was also reduced because the deforming motion of a piece had too little energy.
enum class MomentumLost { none, angular, linear };

// Takes `energy_nj` >= 0 of kinetic energy from the nodes of one piece: from its deforming motion
// first, then from its spin, and last from its translation, since no energy may be created.
// Momentum is conserved up to rounding where the result is `none`. A held piece is scaled towards
// rest; the result is `none`.
MomentumLost take_kinetic_energy(std::span<const int> nodes, std::span<const double> mass_g,
                                 std::span<const Vec3> positions_mm, bool held, double energy_nj,
                                 std::vector<Vec3>& velocities_mm_per_s);

// Keeps a reference to the body. Not thread-safe. Energies are summed per piece only where the body
// has several.
class EnergyLimiter {
  public:
    EnergyLimiter(const Body& body, const AssemblyPlan& plan);

    // Records the energies at the start of a step; the assembly's slots must be those of that
    // state.
    void begin(const StepUnderway& step, const Assembly& assembly);

    // The nodes of coupled pieces whose step created more energy than their motion may give back:
    // the deforming motion of a single free piece, otherwise all motion. Also of those that
    // nothing holds and that lost momentum.
    struct Overdrawn {
        std::vector<int> nodes{};
        bool flies = false;   // nothing holds them
        bool unpaid = false;  // all of their motion cannot give back the energy
    };
    // The assembly's slots must be those of the end of the step. Empty where the body is one piece.
    // The energies per piece are kept for limit(), unless forget_end() says that the step's end
    // changed.
    std::vector<Overdrawn> overdrawn(const StepUnderway& step, const Assembly& assembly,
                                     std::span<const std::uint8_t> held);
    void forget_end() { after_.clear(); }
    // The same for a step whose energies per piece were summed elsewhere, see limit().
    struct Balance {
        double energy = 0.0;   // all kinds, including the kinetic one
        double kinetic = 0.0;  // the kinetic part
    };
    std::vector<Overdrawn> overdrawn(const StepUnderway& step, std::span<const Balance> before,
                                     std::span<const Balance> after,
                                     std::span<const std::uint8_t> held) const;

    // The velocity at the end of the step of a piece on which only weight and damping act.
    Vec3 flight(const StepUnderway& step, const Vec3& before_mm_per_s) const;

    struct Outcome {
        bool limited = false;
        MomentumLost lost = MomentumLost::none;
    };
    // Limits `velocities`, those at the end of the step, so that no piece has more energy than it
    // had at the start plus the work of weight. `after` are the body's energies at the end; the
    // assembly's slots must be those of that state. held[i] != 0: the node is fixed or frozen.
    Outcome limit(const StepUnderway& step, const EnergyLedger& after, const Assembly& assembly,
                  std::span<const std::uint8_t> held, std::vector<Vec3>& velocities_mm_per_s) const;

    // The same for a step whose energies were summed elsewhere, one entry per piece: all energy at
    // the start, and at the end without the work of weight. An excess below `rounding` times the
    // energies plus `least_nj` is ignored. Elements and contacts are not evaluated.
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
    // Whether nodes in free flight have lost momentum.
    bool slowed(const StepUnderway& step, std::span<const int> nodes) const;
    // Kinetic energy at the end beside that of the rigid motion [nJ].
    double deforming_energy(const StepUnderway& step, std::span<const int> nodes) const;
    // Groups of pieces that share their energy, ascending; each piece belongs to one group.
    std::vector<std::vector<int>> coupled_pieces(const PotentialList& potentials,
                                                 bool together) const;
    std::vector<Balance> balance(const StepUnderway& step, std::span<const Vec3> positions_mm,
                                 std::span<const Vec3> velocities_mm_per_s,
                                 const Assembly& assembly) const;

    const Body& body_;
    std::vector<int> piece_of_node_;
    std::vector<std::vector<int>> nodes_;  // of each piece
    std::vector<double> mass_g_;           // of each piece
    std::vector<Balance> before_;
    std::vector<Balance> after_;  // at the step's end; empty: not yet summed
};

// Reports what the limiter took from a step that is left with `kinetic_nj`.
void book(const EnergyLimiter::Outcome& outcome, double kinetic_nj, StepReport& report);

}  // namespace hepatica
