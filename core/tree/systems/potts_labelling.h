// SPDX-License-Identifier: GPL-3.0-or-later
// Labels of least energy: what each label costs at each site, plus a tie wherever two neighbours
// differ (the Potts model), by minimal cuts (Boykov, Veksler and Zabih 2001, alpha expansion).
#pragma once

#include <vector>

#include "core/base/job.h"

namespace hepatica {

// Cutting it costs `strength` (0 or more).
struct Tie {
    int a = -1;
    int b = -1;
    double strength = 0.0;
};

struct PottsProblem {
    int labels = 2;
    std::vector<std::vector<double>> costs;  // per site, one for each label
    std::vector<Tie> ties;
};

// With two labels the minimum, with more a labelling that no expansion of one label improves.
// Deterministic. Throws Cancelled, between two cuts.
std::vector<int> least_energy_labels(const PottsProblem& problem, const Job& job = Job());

double energy_of(const PottsProblem& problem, const std::vector<int>& labels);

}  // namespace hepatica
