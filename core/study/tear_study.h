// SPDX-License-Identifier: GPL-3.0-or-later
// What tearing a bar takes, on meshes of several sizes: by a bare force limit and with a fracture
// energy, to the end and with each stop.
#pragma once

#include <string>
#include <vector>

#include "core/base/job.h"
#include "core/tear/tear_law.h"

namespace hepatica {

struct TearStudyOptions {
    double strength_pa = 2e4;
    double fracture_energy_j_m2 = 20.0;
    std::vector<double> edges_mm{2.0, 1.0, 0.67};  // of the cells; > 0
    std::vector<double> tear_factors{0.5, 1.0, 2.0};
    double entropy_budget_nats = 0.3;
    int vertex_budget = 20;
    double step_mm = 0.05;  // by which the end is pulled in a step
};

struct TearRow {
    std::string law;   // "bare limit" or "fracture energy"
    std::string stop;  // "none", "entropy" or "vertices"
    double tear_factor = 1.0;
    double edge_mm = 0.0;
    int tetrahedra = 0;
    double force_max_un = 0.0;  // on the pulled end
    double work_nj = 0.0;       // of fracture, or of what a bare limit lets go
    double opened_mm2 = 0.0;    // of joints that came apart
    int vertices_split = 0;
    int pieces = 1;
    double entropy_produced_max_nats = 0.0;
    double median_step_ms = 0.0;
    struct Sample {
        double pulled_mm = 0.0;
        double force_un = 0.0;
        double entropy_nats = 0.0;
        double entropy_produced_nats = 0.0;
    };
    std::vector<Sample> samples{};  // after each step
};

// A bar of 20 x 4 x 4 mm with a notch of a quarter of its section in its middle, pulled by 10 mm.
// Throws InputError for values out of range, Cancelled.
std::vector<TearRow> study_tear(const TearStudyOptions& options, Job& job);

// Medians over the frames; of each the wall time, or the processor's where that is less.
struct BreakingRow {
    int tetrahedra = 0;
    double joints = 0.0;     // that broke in a frame
    double awake_ms = 0.0;   // a frame in which none does
    double breaks_ms = 0.0;  // the one in which they break
    double after_ms = 0.0;   // the one behind it, the first of the torn body
};

// The symmetric tree of 63 branches, of about so many tetrahedra each row, its far end led around
// by 2 mm, all of it awake. Around a place that is another in every try, the hundred joints that
// are nearest lose their strength and break at once. Throws Cancelled.
std::vector<BreakingRow> study_breaking(const std::vector<int>& tetrahedra, int tries, Job& job);

}  // namespace hepatica
