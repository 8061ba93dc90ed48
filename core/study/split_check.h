// SPDX-License-Identifier: GPL-3.0-or-later
// Checks what must hold after every transaction that split a body. The checks use only the torn
// body and none of the code that splits.
#pragma once

#include <string>
#include <vector>

#include "core/deform/body/body.h"
#include "core/deform/stepper/stepper.h"

namespace hepatica {

class SplitCheck {
  public:
    // `whole`: the untorn body, kept as a reference; `options`: those of its stepper.
    SplitCheck(const BodyDescription& whole, const StepperOptions& options);

    // Returns what does not hold, or an empty text. Call after every step and cut, in order;
    // `before` holds the energies just before the split. Costs nothing where nothing was split.
    // Checks that
    // - mass, momentum, angular momentum and kinetic energy are unchanged to 1e-12, and the stored
    //   energy did not grow
    // - every new vertex lies where the one does that it was split from; a motion that old vertices
    //   shared with it would not be seen
    // - positions are finite
    // - the tetrahedra around every vertex are connected by faces
    // - the surface is closed, and equals the surface of the topology.
    std::string after_step(const Stepper& stepper, const EnergyLedger& before);

    int splits() const { return splits_; }
    // Transactions after which a tetrahedron was inverted (by a tool or a hand, as a split moves
    // nothing); and after which the surface touched itself along an edge.
    int with_inverted() const { return with_inverted_; }
    int with_touching_edges() const { return with_touching_edges_; }

  private:
    bool in_place(const Stepper& stepper) const;
    std::string conserved(const Stepper& stepper, const EnergyLedger& before);
    std::string well_formed(const Stepper& stepper);

    const BodyDescription& whole_;
    StepperOptions options_;
    std::vector<double> mass_g_;  // of the nodes before the split
    int splits_ = 0, with_inverted_ = 0, with_touching_edges_ = 0;
};

// Whether the tetrahedra around every vertex are connected by faces.
bool fans_connected(const TetMesh& mesh);

}  // namespace hepatica
