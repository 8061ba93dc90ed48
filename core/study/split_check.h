// SPDX-License-Identifier: GPL-3.0-or-later
// What must hold after every transaction in which a body was split, whatever was done to it.
// Counted by code of its own, from the torn body alone: nothing that splits is asked.
#pragma once

#include <string>
#include <vector>

#include "core/deform/body/body.h"
#include "core/deform/stepper/stepper.h"

namespace hepatica {

class SplitCheck {
  public:
    // Of a body that is whole, stepped with these options.
    SplitCheck(const BodyDescription& whole, const StepperOptions& options);

    // What does not hold; empty: everything does. Called after every step and cut, in order;
    // `before` holds the energies just before anything was split. Where nothing was, it costs
    // nothing. Holds:
    // - mass, momentum, angular momentum and kinetic energy are those of before, to 1e-12;
    //   what is stored is not more
    // - positions are finite, and the split itself turned no tetrahedron inside out
    // - the tetrahedra around every vertex hang together by faces
    // - the surface is closed, and the one that the topology tells
    std::string after_step(const Stepper& stepper, const EnergyLedger& before);

    int splits() const { return splits_; }
    // Transactions after which a tetrahedron was inside out, pulled so by a tool or a hand; and
    // after which the surface touched itself along an edge.
    int with_inverted() const { return with_inverted_; }
    int with_touching_edges() const { return with_touching_edges_; }

  private:
    std::string conserved(const Stepper& stepper, const EnergyLedger& before);
    std::string well_formed(const Stepper& stepper);

    const BodyDescription& whole_;
    StepperOptions options_;
    std::vector<double> mass_g_;  // of the nodes, before
    int splits_ = 0, with_inverted_ = 0, with_touching_edges_ = 0;
};

// Whether the tetrahedra around every vertex hang together by faces.
bool fans_connected(const TetMesh& mesh);

}  // namespace hepatica
