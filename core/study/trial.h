// SPDX-License-Identifier: GPL-3.0-or-later
// Steps a body and checks that its state stays finite and no energy is created.
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
    // The ledger's imbalance is judged relative to the energy that the step handled, but at least
    // to `ledger_share` of the most that any step has handled, and to `least_nj`. Keeps references
    // to stepper and row.
    Trial(Stepper& stepper, ExtremeRow& row, ExtremeRun how, double ledger_share = 0.0,
          double least_nj = 0.0)
        : stepper_(stepper),
          row_(row),
          how_(std::move(how)),
          ledger_share_(ledger_share),
          least_nj_(least_nj) {}

    // Makes up to `steps` steps; returns false as soon as something is wrong, which the row's note
    // then says.
    bool run(int steps, double dt_s);

    // The checks of run(), for one step that was just made.
    bool judge(const StepReport& report);

    // Fails the row unless `good`; returns `good`.
    bool require(bool good, const std::string& what);
    // Records the relative error, and fails the row where it is larger than allowed or not a
    // number.
    bool require_close(double value, double expected, double allowed, const std::string& reference);
    // The same of at least one value, judged by the one that is furthest from what is expected, or
    // is not a number.
    bool require_all_close(std::span<const double> values, double expected, double allowed,
                           const std::string& reference);

    // Requires that no element of the body, tetrahedron or hexahedron, is flat or inverted at a
    // corner or an integration point. Body, model and order must be those of the stepper.
    bool require_positive_volumes(const BodyDescription& body, ElementModel model,
                                  ElementOrder order);
    // Requires that no vertex is further from its place than allowed.
    bool require_back_at(std::span<const Vec3> places_mm, double allowed_mm);

    // Checks the energies of a step, as run() does: all are finite, no more is stored than before
    // plus what was put in, the ledger explains the rest, and the stored energy fell by the work of
    // the forces.
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
