// SPDX-License-Identifier: GPL-3.0-or-later
// Force, work and entropy of tearing a bar, on meshes of several sizes: with a bare force limit and
// with a fracture energy, without and with each stop.
#pragma once

#include <string>
#include <vector>

#include "core/base/job.h"
#include "core/deform/stepper/stepper_options.h"
#include "core/tear/tear_law.h"

namespace hepatica {

struct TearStudyOptions {
    double strength_pa = 2e4;
    double fracture_energy_j_m2 = 20.0;
    std::vector<double> edges_mm{2.0, 1.0, 0.67};  // of the cells; > 0
    std::vector<double> tear_factors{0.5, 1.0, 2.0};
    double entropy_budget_nats = 0.3;
    int vertex_budget = 20;
    double step_mm = 0.05;  // by which each step pulls the end
};

struct TearRow {
    std::string law;   // "bare limit" or "fracture energy"
    std::string stop;  // "none", "entropy" or "vertices"
    double tear_factor = 1.0;
    double edge_mm = 0.0;
    int tetrahedra = 0;
    double force_max_un = 0.0;  // on the pulled end
    double work_nj = 0.0;       // energy of fracture, or released by a bare limit
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

// Tears a bar of 20 x 4 x 4 mm with a notch of a quarter of its section in its middle, pulled by 10
// mm. Begins one stage of the job. Throws InputError for values out of range, Cancelled.
std::vector<TearRow> study_tear(const TearStudyOptions& options, Job& job);

// The bar, torn with a setting of the solver.
struct TornBar {
    TearRow row;
    double frame_ms = 0.0;    // 95th percentile, see FrameTime::cost_ms
    double iterations = 0.0;  // linear, mean over the substeps
};

// Tears the bar of study_tear() with cells of one size; each frame of 1/60 s pulls by `step_mm`.
// Throws InputError for values out of range and for a setting that cannot tear, Cancelled.
TornBar tear_bar(double edge_mm, const TearLaw& law, double step_mm, const StepperOptions& options,
                 const Job& job);

// Medians over the frames; each time is wall time, or processor time where that is less.
struct BreakingRow {
    int tetrahedra = 0;
    double joints = 0.0;     // broken in a frame
    double awake_ms = 0.0;   // of a frame in which none breaks
    double breaks_ms = 0.0;  // of the frame in which they break
    double after_ms = 0.0;   // of the next frame, the first of the torn body
};

// Leads the far end of the symmetric tree of 63 branches around a circle of 2 mm radius, all of it
// awake, with about `tetrahedra` tetrahedra in each row. In every try the hundred joints nearest to
// another place lose their strength and break at once. Begins one stage of the job. Throws
// Cancelled.
std::vector<BreakingRow> study_breaking(const std::vector<int>& tetrahedra, int tries, Job& job);

}  // namespace hepatica
