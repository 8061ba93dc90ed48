// SPDX-License-Identifier: GPL-3.0-or-later
// The paper's Fig. 3 on a patient: plays a script that draws cut lines and pulls, and selects four
// of its moments by the state of the vessel.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "app/album.h"
#include "core/base/job.h"
#include "core/patient/patient_case.h"
#include "core/session/script.h"
#include "core/tear/tear_state.h"

namespace hepatica {

struct TearMoment {
    double time_s = 0.0;
    double force_un = 0.0;  // force of the hand
    TearReport tear;
    std::vector<LineMark>
        lines;  // the deformed axis; in the first moment also rings at the cut lines
    std::vector<CircleMark> circles;  // only in the last moment: where it tore
    Frame frame;
    std::string words;  // caption
};

struct TearFigure {
    // At rest; at the largest force before a section is torn through; just after that; at the end
    // of the pull.
    std::array<TearMoment, 4> moments;
    Chart force;                 // force of the hand over time, with the four moments
    std::array<Vec3, 2> box_mm;  // around the pulled stretch at all times
    double work_nj = 0.0;        // of fracture
    double force_max_un = 0.0;
    double entropy_produced_max_nats = 0.0;
    double body_mass_error_relative = 0.0;
};

// Plays the script until it releases the grab. The script must name its scene, cut lines at single
// places by their share of the longest path, and one pull. Begins two stages of the job. Throws
// InputError for any other script, and for a case without a body; Cancelled.
TearFigure play_tear_figure(const std::shared_ptr<const PatientCase>& patient, const Script& script,
                            Job& job);

}  // namespace hepatica
