// SPDX-License-Identifier: GPL-3.0-or-later
// The stiffness-proportional damping of a step in progress: beta K_0 w of eq. (11), where K_0 is
// that of the first iterate throughout the step. beta K_0 is never assembled by itself; it is what
// is left of the first iterate's matrix, eq. (12), without inertia, the potentials and E.
#pragma once

#include <vector>

#include "core/deform/body/body.h"
#include "core/deform/step/incremental_potential.h"
#include "core/deform/step/step_underway.h"

namespace hepatica {

// Keeps a step's damping_force [uN per node] and damping_form up to date. Where the body has no
// such damping (beta = 0) it computes nothing and damping_force stays empty. `beside` is what the
// first iterate's matrix holds in addition to eq. (12): VelocityError's matrix, or null. Keeps
// references to the body and to the potential. Not thread-safe; the same bits for any number of
// threads.
class StepDamping {
  public:
    StepDamping(const Body& body, IncrementalPotential& potential)
        : body_(body), potential_(potential) {}

    bool any() const { return body_.damping.beta_s > 0.0; }

    // The positions of the first iterate, whose matrix is assembled next.
    void begin(const std::vector<Vec3>& first_mm);
    const std::vector<Vec3>& first_mm() const { return first_mm_; }
    // For a first iterate that starts from a velocity w != 0: finds the damping at w and adds its
    // effect to the residual and to the step's value.
    void add_at_start(StepUnderway& step, std::vector<Vec3>& residual);

    // The direction d that the first iterate takes. From rest: elastic_form is (dt d)^T K_0 (dt d).
    // From a moving state: `product` is the first iterate's matrix times d, and is overwritten.
    void take_from_rest(const StepUnderway& step, double elastic_form);
    void take(const StepUnderway& step, const std::vector<Vec3>& d, std::vector<Vec3>& product,
              const BlockMatrix* beside);

    // hold() notes the damping of the step. advance() finds it after step_length times the
    // iterate's direction was added to the step's velocity; release() goes back to what was noted.
    void hold(const StepUnderway& step);
    void advance(StepUnderway& step, double step_length);
    void release(StepUnderway& step) const;

    // Before the second iterate's matrix overwrites the first one's: keeps beta K_0 and finds the
    // damping at the step's velocity.
    void keep(StepUnderway& step, const BlockMatrix* beside);

    // Fills a damping_force that is empty, which a first iterate from rest leaves so. The first
    // iterate's matrix must still be in place.
    void complete(StepUnderway& step, const BlockMatrix* beside);
    // Finds the damping after the step's velocity was replaced, at any iterate.
    void find_again(StepUnderway& step, const BlockMatrix* beside);

  private:
    void from_product(const StepUnderway& step, const std::vector<Vec3>& velocity,
                      std::vector<Vec3>& product, const BlockMatrix* beside,
                      std::vector<Vec3>& damping) const;

    const Body& body_;
    IncrementalPotential& potential_;
    std::vector<Vec3> first_mm_;
    double direction_form_ = 0.0;       // first direction from rest: direction^T beta K_0 direction
    std::vector<Vec3> before_, along_;  // damping when held; beta K_0 times the first direction
    double form_before_ = 0.0;
    std::vector<Vec3> product_;
};

}  // namespace hepatica
