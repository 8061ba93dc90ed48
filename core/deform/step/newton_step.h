// SPDX-License-Identifier: GPL-3.0-or-later
// Newton's method on the incremental potential of a step: a direction from one linear system, and a
// line search (Armijo) that never accepts an increase. The first iterate with step length 1 is the
// published step, eq. (12).
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "core/deform/body/body.h"
#include "core/deform/solvers/linear_solver.h"
#include "core/deform/step/incremental_potential.h"
#include "core/deform/step/step_damping.h"
#include "core/deform/step/step_report.h"
#include "core/deform/step/step_system.h"
#include "core/deform/step/step_underway.h"
#include "core/deform/step/velocity_error.h"

namespace hepatica {

struct NewtonSettings {
    int iterations = 1;  // at most; 1 is the linearly implicit step
    // Iterates stop when no node moves further than this share of the mean edge length at rest.
    double tolerance = 1e-6;
    // If false, a single iterate is taken whole, as published, whatever it does to the energy.
    bool line_search = true;
    // Linear solves of one step in addition to `iterations`: for iterates after a shortened step
    // from rest, and for the halves of a divided step. The budget is the sum of both.
    int extra_solves = 24;
    bool tension = false;              // see StepperOptions
    RayleighDamping velocity_error{};  // E of eq. (11), see StepperOptions
    SolveLimits linear{};
    bool audit = false;  // see StepperOptions
};

// Vectors have one entry per node: positions in mm, velocities in mm/s. Keeps references to the
// body and to the potential. Not thread-safe; the same bits for any number of threads.
class NewtonStep {
  public:
    NewtonStep(const Body& body, IncrementalPotential& potential,
               std::unique_ptr<LinearSolver> solver);

    void set_settings(const NewtonSettings& settings);

    // Iterates as set, with at most `most_solves` >= 1 linear solves, which the report counts.
    // False where no step length lowers the potential along the first direction; the velocity is
    // then 0. Throws Cancelled after the step's stop is requested; then the solver must be restored
    // before the next step.
    bool find_velocity(StepUnderway& step, int most_solves, StepReport& report);

    std::unique_ptr<LinearSolver> release_solver() { return system_.release_solver(); }

    // Fills the step's damping_force, which a first iterate from rest leaves out.
    void find_damping(StepUnderway& step) { damping_.complete(step, velocity_error()); }

    // Replaces the velocity at the end of the step and evaluates the potential there. Returns false
    // and changes nothing where that motion would pass through something.
    bool replace_velocity(StepUnderway& step, const std::vector<Vec3>& velocity);

    // See StepSystem.
    SolverCheckpoint checkpoint() const { return system_.checkpoint(); }
    void restore(const SolverCheckpoint& checkpoint) { system_.restore(checkpoint); }

  private:
    SolverCheckpoint origin_of(const StepUnderway& step) const;
    // Whether the first iterate's matrix has the rotational stiffness of taut elements.
    bool taut(const StepUnderway& step) const {
        return settings_.tension && potential_.taut() && (step.predicted || calm(step));
    }
    void predict(StepUnderway& step);
    bool begin_at(StepUnderway& step, const std::vector<Vec3>& velocity);
    void stay_at_start(StepUnderway& step);
    bool iterate_from_here(StepUnderway& step, int most_solves, StepReport& report);
    bool iterate(StepUnderway& step, StepReport& report);
    int iterates_after_cut(const StepUnderway& step) const;
    // What the first iterate's matrix holds beside eq. (12); may be null.
    const BlockMatrix* velocity_error() const {
        return velocity_error_.any() ? &velocity_error_.matrix() : nullptr;
    }
    void find_product_of_change();
    void add_to_free(double factor, const BlockMatrix& matrix, const std::vector<Vec3>& x);
    void solve(const StepUnderway& step, StepReport& report);
    void add_coupling(const StepUnderway& step, std::span<const Vec3> d,
                      std::span<Vec3> product) const;
    void keep_linearised_work(StepUnderway& step);
    double free_length(const StepUnderway& step) const;
    bool meets_pads(const StepUnderway& step) const;
    bool still(const StepUnderway& step) const;
    bool calm(const StepUnderway& step) const;
    bool search_line(StepUnderway& step);
    bool try_step_length(StepUnderway& step, double step_length, double slope);

    const Body& body_;
    IncrementalPotential& potential_;
    StepSystem system_;
    NewtonSettings settings_;
    VelocityError velocity_error_;
    StepDamping damping_;
    std::vector<Vec3> direction_;  // of the velocity
    std::vector<Vec3> velocity_before_;
    std::vector<Vec3> residual_, steepest_, change_, product_;
};

}  // namespace hepatica
