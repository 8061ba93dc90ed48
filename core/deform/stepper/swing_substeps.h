// SPDX-License-Identifier: GPL-3.0-or-later
// How many substeps a step takes while a body swings back that was let go. Backward Euler misses
// dt/2 |dv| of the positions in a step (its local error, dt² x''/2); a vessel in tissue swings back
// within one or two frames of 1/60 s, so that dv is large in these and small in all others. They
// are cut until each substep misses no more than a share of an edge.
#pragma once

#include <span>

#include "core/deform/body/body.h"
#include "core/deform/body/body_state.h"

namespace hepatica {

class SwingSubsteps {
  public:
    // The body was let go with this energy of deformation [nJ], all of which may become motion.
    void let_go(const Body& body, double energy_nj);
    // Forgets it: something holds the body again, or its state was set.
    void hold() { change_mm_per_s_ = 0.0; }

    // Substeps of the next step, from 1 to `most` >= 1.
    int count(const Body& body, double dt_s, int most) const;

    // To be called after a step of `substeps` that began with these velocities: the next one is
    // expected to change them as much. Once a single substep was enough, the swing is over. Costs a
    // pass over the nodes while it lasts.
    void watch(const Body& body, std::span<const Vec3> velocities_before, const BodyState& state,
               int substeps);
    bool swings() const { return change_mm_per_s_ > 0.0; }

    // For a checkpoint: the expected change of velocity, root mean square by mass [mm/s]; 0 where
    // nothing swings.
    double change_mm_per_s() const { return change_mm_per_s_; }
    void restore(double change_mm_per_s) { change_mm_per_s_ = change_mm_per_s; }

  private:
    double change_mm_per_s_ = 0.0;
};

}  // namespace hepatica
