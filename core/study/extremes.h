// SPDX-License-Identifier: GPL-3.0-or-later
// The stability suite: bodies and scenes at the edge of what can be asked, a row each. A row passes
// if everything stayed finite, no energy was made, the body came back when released, and, where an
// independent answer exists (beam theory, free fall, conservation), the error against it is small;
// or if what cannot be simulated was refused with an InputError.
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

// How a row is run: it throws Cancelled soon after a stop was asked for. Where it may not step as
// often at a time as it wants to, all that it does to its body still happens, but what it expects
// of rest and return need not hold.
struct ExtremeRun {
    std::stop_token stop;
    int most_steps = std::numeric_limits<int>::max();

    ExtremeRun() = default;
    ExtremeRun(std::stop_token asked) : stop(std::move(asked)) {}  // NOLINT: a stop is how
};

struct ExtremeRow {
    std::string name;  // "beam corotated-10 E=1e6 dt=0.1 nu=0.3"
    bool survived = false;
    bool refused = false;      // by name, and rightly
    std::string note;          // what went wrong, or the words of the refusal
    double energy_made = 0.0;  // largest of any step, relative to what it handled
    double path_mm = 0.0;      // of a vertex, the mean of them, over all steps
    int touched_steps = 0;     // steps after which surfaces, a tool or obstacles touch
    int splits = 0;            // transactions in which a body that tears was split;
    int inverted_splits = 0;   // after how many of them a tetrahedron was inside out,
    int touching_splits = 0;   // and the surface touched itself along an edge
    int degraded_steps = 0;    // steps that the stepper itself shortened or braked, and said so
    // Where energies and forces were audited against each other (see energy_ledger.h): the largest
    // gap of any step, relative to what it handled; and steps whose way crossed so many inverted
    // elements that the work of the forces could not be told to 1e-3.
    double audit_gap = 0.0;
    int unresolved_steps = 0;
    double error = std::numeric_limits<double>::quiet_NaN();  // relative to the reference
    std::string reference;  // what the error is measured against; empty: nothing independent
};

struct ExtremeCase {
    std::string name;
    std::function<ExtremeRow(const ExtremeRun& how)> run;
};

// All of them, more than 200, in a fixed order.
std::vector<ExtremeCase> extreme_cases();

// So many trials on random bodies; a trial of one seed is the same whatever is run beside it.
struct Campaign {
    std::uint64_t seed = 1;
    int trials = 500;
    int steps = 600;
    int most_tetrahedra = 2000;
    // Played on by turns in the place of random bodies; touch only.
    std::vector<std::shared_ptr<const BodyDescription>> patients{};
};

using TouchCampaign = Campaign;

// Random vessel trees in touch: tools led through them at 0.01 to 100 m/s, turned and closed,
// vessels dragged through each other and a knot pulled. At 20 looks of each nothing crosses and no
// tool stands in a vessel. Tools, drags and knots take turns, on patients all but knots; a random
// mesh that crosses itself at rest is refused, what overlaps on a patient is left out until it has
// come apart.
std::vector<ExtremeCase> touch_cases(const Campaign& campaign);

// Random vessel trees that tear, by any law, element and stop: pulled, pressed by a tool, twisted
// and cut at 10 to 1000 mm/s, these by turns. What split_check.h asks is looked at after every
// transaction in which something split; energies as in every trial.
std::vector<ExtremeCase> tear_cases(const Campaign& campaign);

// Runs those whose name contains `filter` (all where it is empty). Throws Cancelled.
std::vector<ExtremeRow> run_extremes(const std::vector<ExtremeCase>& cases,
                                     const std::string& filter, Job& job);

}  // namespace hepatica
