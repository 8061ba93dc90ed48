// SPDX-License-Identifier: GPL-3.0-or-later
// An opened patient with what plays it: which vessel lies under the mouse, each branch's share of
// the flow, and a simulation on a thread of its own. No toolkit.
#pragma once

#include <memory>
#include <vector>

#include "core/opening/open_patient.h"
#include "core/scene/deform_back_end.h"
#include "core/scene/surface_anatomy.h"
#include "ui/simulation.h"

namespace hepatica {

struct LoadedPatient : OpenedPatient {
    SurfaceAnatomy anatomy;
    std::filesystem::path asked_for{};  // what was opened; empty: the built-in, or a correction
    std::vector<double> flow_shares;    // per segment, see flow_shares.h; may be empty
    std::unique_ptr<Simulation> simulation;  // running
};

// A patient that is in memory, with its simulation running. Throws InputError, Cancelled.
LoadedPatient play(std::shared_ptr<const PatientCase> patient, Job& job);
LoadedPatient play_with(const DeformBackEnd& back_end, std::shared_ptr<const PatientCase> patient,
                        Job& job);

// Throws InputError for whatever cannot be opened (with file, value and remedy), Cancelled. Among
// the warnings is what of his dial the back end cannot play.
LoadedPatient load_patient(const OpenRequest& request, Job& job,
                           const DeformBackEnd& back_end = cpu_back_end());

}  // namespace hepatica
