// SPDX-License-Identifier: GPL-3.0-or-later
// Steps a body and watches what no body may do: leave the finite numbers, or make energy.
#pragma once

#include <span>
#include <string>
#include <utility>

#include "core/deform/body/body.h"
#include "core/deform/stepper/stepper.h"
#include "core/study/extremes.h"

namespace hepatica {

class Trial {
  public:
    static constexpr double ledger_tolerance = 1e-9;
    // What the ledger leaves open is judged against what the step handled, but at least against
    // this share of the most that any step has handled, and against `least_nj`.
    Trial(Stepper& stepper, ExtremeRow& row, ExtremeRun how, double ledger_share = 0.0,
          double least_nj = 0.0)
        : stepper_(stepper),
          row_(row),
          how_(std::move(how)),
          ledger_share_(ledger_share),
          least_nj_(least_nj) {}

    // Steps, as often as it may; false as soon as something is wrong, which the row then says.
    bool run(int steps, double dt_s);

    // What run() asks of each step, of one that was just made.
    bool judge(const StepReport& report);

    // Fails the row unless `good`.
    bool require(bool good, const std::string& what);
    // Books the error and fails the row where it is larger than allowed or not a number.
    bool require_close(double value, double expected, double allowed, const std::string& reference);

    // No element of the body, tetrahedron or hexahedron, is flat or inside out at a corner or an
    // integration point. Body, model and order are those the stepper was made with.
    bool require_positive_volumes(const BodyDescription& body, ElementModel model,
                                  ElementOrder order);
    // No vertex further from its place than allowed.
    bool require_back_at(std::span<const Vec3> places_mm, double allowed_mm);

    // Of the next step, as run() asks of every step: nothing more is stored than before and put in,
    // the ledger says where the rest went, and what is stored fell by the work of the forces.
    bool check_energy(const StepReport& report);

  private:
    bool check_audit(const StepReport& report, double in_step);

    Stepper& stepper_;
    ExtremeRow& row_;
    ExtremeRun how_;
    double ledger_share_, least_nj_;
    double stored_ = 0.0;   // after the last step
    double handled_ = 0.0;  // the most in any step so far
    bool started_ = false;
};

}  // namespace hepatica
