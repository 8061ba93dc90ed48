// SPDX-License-Identifier: GPL-3.0-or-later
// Force and work to tear, and their error against cost, over the settings and meshes of a scene
// that tears. A notched bar is torn through; the reference is the same tear on the finest mesh,
// solved tightly in short steps.
#pragma once

#include <string>
#include <vector>

#include "core/base/job.h"
#include "core/study/named_points.h"
#include "core/study/tear_study.h"
#include "core/study/tradeoff.h"

namespace hepatica {

// A setting with tears, and its measurements.
struct TearPoint {
    std::string name;  // how it differs from a scene's setting
    double edge_mm = 1.0;
    double force_max_un = 0.0;  // on the pulled end
    double work_nj = 0.0;       // energy of fracture
    double force_error = 0.0;   // |force_max_un - the reference's| over the reference's
    double work_error = 0.0;    // as force_error
    double opened_mm2 = 0.0;    // with the notch
    int pieces = 1;
    TradeoffPoint point;  // error_relative: RMS of the force over the pull
};

struct TearTradeoff {
    std::vector<TearPoint> points;
    std::string reference;
    double reference_force_max_un = 0.0;
    double reference_work_nj = 0.0;
};

struct TearTradeoffOptions {
    double edge_mm = 1.0;                           // of the mesh of the settings; > 0
    std::vector<double> other_edges_mm{2.0, 0.67};  // of the other meshes; > 0
    double tight_edge_mm = 0.67;                    // of the reference's mesh; > 0
    double step_mm = 0.05;                          // by which each frame pulls; > 0
};

// Points are in the order of the settings, with the front marked. Begins two stages of the job.
// Throws InputError for values out of range, Cancelled.
TearTradeoff measure_tear_tradeoff(const TearTradeoffOptions& options, Job& job);

}  // namespace hepatica
