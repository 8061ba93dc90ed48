// SPDX-License-Identifier: GPL-3.0-or-later
// Pieces of a body that do not take a step, because it would make energy or take the momentum of
// their flight: what nothing holds continues its rigid motion, the rest stands still. Pieces that
// meet on such a flight continue the rigid motion of all of them together, in which none comes
// nearer to another and which has their momentum: a plastic impact.
#pragma once

#include <span>
#include <vector>

#include "core/deform/body/body.h"
#include "core/deform/step/energy_limiter.h"
#include "core/deform/step/step_underway.h"

namespace hepatica {

// Of one step. Keeps references to all three.
class DeclinedPieces {
  public:
    DeclinedPieces(const Body& body, const EnergyLimiter& limiter, const StepUnderway& step);

    // Declines the step for what is overdrawn at its present end. False where nothing changes.
    // Pieces are only added and joined, and what stands never moves again, so that this ends.
    bool add(std::span<const EnergyLimiter::Overdrawn> overdrawn);

    // Those of the step, but for the declined pieces.
    std::vector<Vec3> velocities() const;

  private:
    struct Group {
        std::vector<int> nodes{};
        bool flies = false;
    };
    bool add(const EnergyLimiter::Overdrawn& pieces);
    std::vector<int> groups_in(const std::vector<int>& nodes) const;

    const Body& body_;
    const EnergyLimiter& limiter_;
    const StepUnderway& step_;
    std::vector<Group> groups_;  // empty once it is part of another
    std::vector<int> group_of_;  // of each node; -1: it takes the step
};

}  // namespace hepatica
