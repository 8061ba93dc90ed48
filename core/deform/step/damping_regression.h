// SPDX-License-Identifier: GPL-3.0-or-later
// The velocity-dependent error E of eq. (11): the residual of the first-order expansion of the
// force from one recorded step to the next, regressed on the change of velocity. With the signs of
// eq. (12), E = -(e_m M + e_k K), so that it adds to the coefficients of Rayleigh damping.
#pragma once

#include <span>

#include "core/deform/body/body.h"
#include "core/deform/body/body_state.h"
#include "core/deform/body/material.h"

namespace hepatica {

struct DampingFit {
    RayleighDamping error;   // e_m [1/s] and e_k [s]; both 0 where the fit is not used
    double r_squared = 0.0;  // share of the squared residual that the fit explains, in [0, 1]
    int steps = 0;           // number of recorded steps in the fit
    bool used = false;       // r_squared reached the threshold
};

// Least squares of r on -(e_m M dv + e_k K dv), without a constant term.
class DampingRegression {
  public:
    // Adds one step's residual, M dv and K dv, all of the same size.
    void add(std::span<const Vec3> residual_un, std::span<const Vec3> mass_times_dv,
             std::span<const Vec3> stiffness_times_dv);
    // The error is 0 where less than `threshold` of the residual is explained.
    DampingFit fit(double threshold = 0.1) const;

  private:
    double mm_ = 0.0, mk_ = 0.0, kk_ = 0.0, rm_ = 0.0, rk_ = 0.0, rr_ = 0.0;
    int steps_ = 0;
};

// Fits consecutive recorded states of a body: the residual f(x',v') - (f + B dv + K dx) with
// elastic and damping forces, K and B taken at the earlier state.
DampingFit fit_damping(const Body& body, std::span<const BodyState> recorded,
                       double threshold = 0.1);

}  // namespace hepatica
