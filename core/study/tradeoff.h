// SPDX-License-Identifier: GPL-3.0-or-later
// Error against cost over the dial's coordinates: solver, its limit, element, order, mesh, length
// of the step, Newton iterates, region. On the clamped beam, whose answer is known, or on a body of
// one's own.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/base/job.h"
#include "core/deform/body/body.h"
#include "core/deform/stepper/live_region.h"
#include "core/deform/stepper/stepper_options.h"
#include "core/scene/deform_back_end.h"

namespace hepatica {

struct TradeoffPoint {
    std::string element;           // as in discretisation_of
    int elements = 0;              // of the mesh
    std::string region = "whole";  // or "live": only what moves or is held is computed
    std::string back_end = "cpu";  // that made the steps, and the device that this is
    std::string device;            // by its own name; empty: the processor
    StepperOptions options;
    double dt_s = 0.0;            // of one substep
    double step_ms = 0.0;         // of one substep, as below
    double frame_ms = 0.0;        // what 95 of 100 frames of 1/60 s take at most, see FrameMeter
    double iterations = 0.0;      // linear, mean over the substeps
    double error_relative = 0.0;  // of the motion, root mean square over half a second
    double rest_error_relative = 0.0;  // two seconds after gravity set in; NaN: not measured
    bool own_mesh = true;              // the mesh that the body is played with
    bool on_front = false;
    double quality = 0.0;      // of the points on the front, 0 the cheapest, 1 the most accurate
    std::string not_measured;  // why; empty where it was. The figures are then NaN
};

struct Tradeoff {
    std::vector<TradeoffPoint> points;  // measured or not, in the order of the settings
    std::string reference;              // what error_relative is measured against
    std::string rest_reference;         // what rest_error_relative is; empty: nothing
    double reference_tip_mm = 0.0;      // of the beam; 0 for other bodies
    double timoshenko_tip_mm = 0.0;     // linear theory, for comparison
    double seconds = 0.0;               // that the measurement took
};

struct TradeoffOptions {
    double budget_s = 300.0;   // wall time; what does not fit is listed as not measured. > 0
    bool quick = false;        // of the beam: leave out the large meshes
    LiveRegionOptions region;  // of the live settings of a body of one's own
    // On whose device those are measured, too, beside the processor.
    std::optional<DeformBackEnd> device;
};

// The beam of BeamSpec over some fifty settings. Throws Cancelled, after a frame at most.
Tradeoff measure_beam_tradeoff(const TradeoffOptions& options, Job& job);

// A body of one's own, fixed somewhere and with a skeleton, over some thirty settings: a Pull on
// meshes[0], the one that is played with; the others are of the same shape, in other sizes. The
// reference is the motion of quadratic elements on meshes[0] in eight substeps a frame where two
// fifths of the budget allow it, or else of linear ones in up to 32; it is the processor's. Each
// setting is measured on the device, too, where one is given; those that the device leaves to the
// processor are not measured there. Throws InputError, Cancelled (after a substep).
Tradeoff measure_body_tradeoff(const std::vector<BodyDescription>& meshes,
                               const TradeoffOptions& options, Job& job);

// Marks the points that no other measured one beats in both cost and error.
void mark_front(Tradeoff& tradeoff);

// FOLDER/tradeoff.csv, one line a point, and FOLDER/tradeoff.svg, error over cost with the front.
// The folder is made where it is missing. Throws InputError where it cannot be written.
void write_tradeoff(const Tradeoff& tradeoff, const std::filesystem::path& folder);

}  // namespace hepatica
