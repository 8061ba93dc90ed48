// SPDX-License-Identifier: GPL-3.0-or-later
// Error against cost over the parameters of the dial: linear solver and its limit, element, order,
// mesh, time step, Newton iterations, region. Measured on the clamped beam, whose answer is known,
// or on a given body.
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
    std::string element;           // as in discretisation_of()
    int elements = 0;              // of the mesh
    std::string region = "whole";  // or "live": only what moves or is held is computed
    std::string back_end = "cpu";  // that made the steps
    std::string device;            // name of its device; empty: the processor
    StepperOptions options;
    double dt_s = 0.0;            // of one substep
    double step_ms = 0.0;         // of one substep: frame_ms over substeps
    double frame_ms = 0.0;        // 95th percentile over frames of 1/60 s, see FrameMeter
    double iterations = 0.0;      // linear, mean over the substeps
    double error_relative = 0.0;  // RMS, of the motion: the beam's first half second, or the pull
    double rest_error_relative = 0.0;  // of the beam at rest after two seconds; NaN: not measured
    bool own_mesh = true;              // whether on the mesh that the body is played with
    bool on_front = false;
    double quality = 0.0;      // on the front: 0 the cheapest, 1 the most accurate
    std::string not_measured;  // reason; empty where measured. Otherwise errors are NaN, and times
                               // NaN or those of the frames made
};

struct Tradeoff {
    std::vector<TradeoffPoint> points;  // measured or not, in the order of the settings
    std::string reference;              // what error_relative is measured against
    std::string rest_reference;      // what rest_error_relative is measured against; empty: nothing
    double reference_tip_mm = 0.0;   // of the beam; 0 for other bodies
    double timoshenko_tip_mm = 0.0;  // linear theory, for comparison
    double seconds = 0.0;            // duration of the measurement
};

struct TradeoffOptions {
    double budget_s = 300.0;  // wall time, > 0; settings that do not fit are listed as not measured
    bool quick = false;       // of the beam: leave out the large meshes
    LiveRegionOptions region;  // for the live settings of a given body
    // Back end on whose device a given body's settings are measured in addition.
    std::optional<DeformBackEnd> device;
};

// Measures the beam of BeamSpec with some seventy settings (`quick`: some fifty-five). Begins two
// stages of the job. Throws Cancelled, after a substep at most.
Tradeoff measure_beam_tradeoff(const TradeoffOptions& options, Job& job);

// Measures a given body, fixed somewhere and with a skeleton, with some 25 settings in a Pull.
// meshes[0] is the mesh that is played with; the others have the same shape and other element
// sizes. The reference is the motion of quadratic elements on meshes[0] with eight substeps a frame
// where two fifths of the budget allow it, or else of linear ones with up to 32, computed on the
// processor. With a device each setting is also measured there, except those that it leaves to the
// processor. Begins three stages of the job. Throws InputError, also where the pull moves nothing;
// Cancelled (after a substep at most).
Tradeoff measure_body_tradeoff(const std::vector<BodyDescription>& meshes,
                               const TradeoffOptions& options, Job& job);

// Whether a point has a place in the plane of cost and error: it was measured, its error is finite
// and its cost finite and above 0.
bool is_measured(const TradeoffPoint& point);

// Marks the Pareto front: the measured points that no other beats in both cost and error.
void mark_front(Tradeoff& tradeoff);

// Writes FOLDER/tradeoff.csv, one line per point, and FOLDER/tradeoff.svg, error over cost with the
// front; `error_name` stands beside its axis. The folder is created if missing. Throws InputError
// where that fails; then neither file is written.
void write_tradeoff(const Tradeoff& tradeoff, const std::filesystem::path& folder,
                    const std::string& error_name = "error of the motion");

}  // namespace hepatica
