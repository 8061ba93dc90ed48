// SPDX-License-Identifier: GPL-3.0-or-later
// Checks what must hold over every transaction that split a body: compares the stepper's state and
// masses just before the split with those behind it. Masses, surfaces and fans are computed here,
// by none of the code that splits.
#pragma once

#include <array>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/deform/body/body.h"
#include "core/deform/stepper/governed_stepper.h"
#include "core/deform/stepper/stepper.h"

namespace hepatica {

// A transaction as the back end saw it. `before` has as many nodes as there were then.
struct SplitMoment {
    BodyState before{}, after{};
    std::vector<double> mass_before_g{}, mass_after_g{};
    EnergyLedger energies_before{};
};

class SplitCheck {
  public:
    // `whole`: the untorn body, kept as a reference; `make`: the back ends that are watched.
    SplitCheck(const BodyDescription& whole, const StepperOptions& options,
               GovernedStepper::MakeBackEnd make = {});

    // The stepper to be checked, with the bits of make_cpu_stepper(); not to outlive this.
    std::unique_ptr<Stepper> make_stepper();

    // Returns what does not hold, or an empty text. Call after every step and cut, in order. Costs
    // nothing where the topology did not change. Checks that
    // - no old vertex was moved, and none changed its velocity; every new one lies where the one
    //   does that it was split from, and moves as it does
    // - before and after, each vertex has a quarter of the mass of its tetrahedra
    // - mass, momentum, angular momentum and kinetic energy are unchanged to 1e-12, and the stored
    //   energy did not grow
    // - what fault_of_shape() asks.
    std::string after_step(const Stepper& stepper);

    int splits() const { return splits_; }
    // Transactions after which a tetrahedron was inverted (by a tool or a hand, as a split moves
    // nothing); and after which the surface touched itself along an edge.
    int with_inverted() const { return with_inverted_; }
    int with_touching_edges() const { return with_touching_edges_; }

  private:
    std::string over(const SplitMoment& moment, const Stepper& stepper);
    std::string well_formed(const Stepper& stepper);

    const BodyDescription& whole_;
    StepperOptions options_;
    GovernedStepper::MakeBackEnd make_;
    std::vector<SplitMoment> moments_;  // since the last after_step()
    std::vector<double> mass_of_tetrahedron_g_;
    std::vector<std::array<int, 4>> tetrahedra_;  // after the last transaction
    int splits_ = 0, with_inverted_ = 0, with_touching_edges_ = 0;
};

// What a split changed of mass and motion, or an empty text. The masses must be as many as the
// nodes of each state.
std::string fault_of_motion(const SplitMoment& moment);

// What is wrong with a torn body and the surface that its topology tells, or an empty text:
// positions must be finite, the tetrahedra around every vertex connected by faces, and the surface
// closed and that of the tetrahedra.
std::string fault_of_shape(const TetMesh& mesh, std::vector<std::array<int, 3>> told_surface);

// Whether the tetrahedra around every vertex are connected by faces.
bool fans_connected(const TetMesh& mesh);

}  // namespace hepatica
