// SPDX-License-Identifier: GPL-3.0-or-later
// Labels of least energy in the Potts model, E = sum of costs of labels at sites + sum of strengths
// of ties between neighbours that differ, by minimal cuts and alpha expansion (Boykov, Veksler and
// Zabih, IEEE Trans Pattern Anal Mach Intell 2001;23:1222).
#pragma once

#include <vector>

#include "core/base/job.h"

namespace hepatica {

// Different labels at sites a and b cost `strength` >= 0.
struct Tie {
    int a = -1;
    int b = -1;
    double strength = 0.0;
};

struct PottsProblem {
    // Number of labels, 2 or more.
    int labels = 2;
    std::vector<std::vector<double>> costs;  // costs[site][label]
    std::vector<Tie> ties;
};

// The global minimum for two labels; for more, a labelling that no expansion of one label improves.
// Deterministic. Throws Cancelled, between two cuts.
std::vector<int> least_energy_labels(const PottsProblem& problem, const Job& job = Job());

double energy_of(const PottsProblem& problem, const std::vector<int>& labels);

}  // namespace hepatica
