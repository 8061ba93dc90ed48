// SPDX-License-Identifier: GPL-3.0-or-later
// Error against cost over the dial's coordinates: solver, its limit, element, order, mesh, length
// of the step, Newton iterates. On the clamped beam, whose answer is known, or on a body of one's
// own.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/job.h"
#include "core/deform/body.h"
#include "core/deform/cpu_stepper.h"

namespace hepatica {

struct TradeoffPoint {
    std::string element;  // as in discretisation_of
    int elements = 0;
    StepperOptions options;
    double dt_s = 0.0;                   // of one substep
    double step_ms = 0.0;                // wall time of one substep, median
    double frame_ms = 0.0;               // wall time for 1/60 s of simulated time, median
    double iterations = 0.0;             // linear, mean over the substeps
    double error_relative = 0.0;         // of the displacement two seconds after gravity set in
    double motion_error_relative = 0.0;  // of the first half second's motion; NaN: not measured
    bool on_front = false;
    double quality = 0.0;  // of the points on the front, 0 the cheapest, 1 the most accurate
};

struct Tradeoff {
    std::vector<TradeoffPoint> points;
    std::string reference;           // what the errors are measured against
    double reference_tip_mm = 0.0;   // of the beam; 0 for other bodies
    double timoshenko_tip_mm = 0.0;  // linear theory, for comparison
};

// The beam of BeamSpec over some forty settings; `quick` leaves out the large meshes.
Tradeoff measure_beam_tradeoff(bool quick, Job& job);

// A body of one's own, clamped somewhere, under gravity: its mesh stays, the rest varies.
Tradeoff measure_body_tradeoff(const BodyDescription& body, Job& job);

// FOLDER/tradeoff.csv, one line a point, and FOLDER/tradeoff.svg, error over cost with the front.
// The folder is made where it is missing. Throws InputError where it cannot be written.
void write_tradeoff(const Tradeoff& tradeoff, const std::filesystem::path& folder);

}  // namespace hepatica
