// SPDX-License-Identifier: GPL-3.0-or-later
// The stability suite: bodies and scenes in extreme conditions, one row each. A row passes if
// everything stayed finite, no energy was created, the body returned when released, and, where an
// independent answer exists (beam theory, free fall, conservation), the error against it is small;
// or if input that cannot be simulated was refused with an InputError.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

#include "core/base/job.h"
#include "core/deform/body/body.h"

namespace hepatica {

// How a row is run. It throws Cancelled soon after a stop was requested. With `most_steps` per
// stretch everything is still done to the body, but its expectations of rest and return need not
// hold.
struct ExtremeRun {
    std::stop_token stop;
    int most_steps = std::numeric_limits<int>::max();

    ExtremeRun() = default;
    ExtremeRun(std::stop_token asked) : stop(std::move(asked)) {}  // NOLINT: a stop is how
};

struct ExtremeRow {
    std::string name;  // "beam corotated-10 E=1e6 dt=0.1 nu=0.3"
    bool survived = false;
    bool refused = false;      // correctly refused
    std::string note;          // what went wrong, or the text of the refusal
    double energy_made = 0.0;  // largest of any step, relative to the energy it handled
    double path_mm = 0.0;      // path of a vertex over all steps, mean over the vertices
    int touched_steps = 0;     // steps after which surfaces, a tool or obstacles touch
    int splits = 0;            // transactions in which a tearing body was split
    int inverted_splits = 0;   // of these, after how many a tetrahedron was inverted
    int touching_splits = 0;   // of these, after how many the surface touched itself along an edge
    int degraded_steps = 0;    // steps that the stepper shortened or damped, and reported
    // Audit of energies against forces (energy_ledger.h): the largest gap of any step, relative to
    // the energy it handled; and the number of steps that crossed so many inverted elements that
    // the work of the forces could not be computed to 1e-3.
    double audit_gap = 0.0;
    int unresolved_steps = 0;
    double error = std::numeric_limits<double>::quiet_NaN();  // relative to the reference
    std::string reference;  // what the error is measured against; empty: no independent reference
};

struct ExtremeCase {
    std::string name;
    std::function<ExtremeRow(const ExtremeRun& how)> run;
};

// All rows, more than 200, in a fixed order.
std::vector<ExtremeCase> extreme_cases();

// A number of trials on random bodies; a trial depends only on the seed and its number.
struct Campaign {
    std::uint64_t seed = 1;
    int trials = 500;
    int steps = 600;
    int most_tetrahedra = 2000;
    // Played on in turn instead of random bodies.
    std::vector<std::shared_ptr<const BodyDescription>> patients{};
    bool touching = false;  // of tears: the surfaces of the bodies touch each other
};

using TouchCampaign = Campaign;

// Random vessel trees in contact: tools led through them at 0.01 to 100 m/s, turned and closed,
// vessels dragged through each other, and a knot pulled. At 20 checks of each trial nothing may
// cross, and no tool may be inside a vessel. Tools, drags and knots take turns; patients get all
// but knots. A random mesh that crosses itself at rest is refused; overlaps of a patient's mesh are
// ignored until they have separated.
std::vector<ExtremeCase> touch_cases(const Campaign& campaign);

// Random vessel trees that tear, with random laws, elements and stops: pulled, pressed by a tool,
// twisted and cut in turn, at 10 to 1000 mm/s; or patients. SplitCheck runs after every transaction
// that splits something; energies are checked as in every trial. Where surfaces touch each other,
// none may cross that contact keeps apart.
std::vector<ExtremeCase> tear_cases(const Campaign& campaign);

// Runs the cases whose name contains `filter` (all where it is empty). Throws Cancelled.
std::vector<ExtremeRow> run_extremes(const std::vector<ExtremeCase>& cases,
                                     const std::string& filter, Job& job);

}  // namespace hepatica
