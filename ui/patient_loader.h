// SPDX-License-Identifier: GPL-3.0-or-later
// An opened patient with everything needed to play: the vessel at each vertex, the branches' shares
// of flow, and a simulation on a thread of its own. No widgets.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/opening/open_patient.h"
#include "core/scene/deform_back_end.h"
#include "core/scene/surface_anatomy.h"
#include "ui/simulation.h"

namespace hepatica {

struct LoadedPatient : OpenedPatient {
    SurfaceAnatomy anatomy;
    std::filesystem::path asked_for{};  // what was opened; empty: built-in or a correction
    // Names of the lessons for him that lie in the file he was read from and not beside it, see
    // packed_lessons.h.
    std::vector<std::string> packed_lessons{};
    std::vector<double> flow_shares;         // per segment, see flow_shares.h; may be empty
    std::unique_ptr<Simulation> simulation;  // running
};

// Prepares the play on a patient in memory. Throws InputError and Cancelled.
LoadedPatient play(std::shared_ptr<const PatientCase> patient, Job& job);
LoadedPatient play_with(const DeformBackEnd& back_end, std::shared_ptr<const PatientCase> patient,
                        Job& job);

// Throws InputError (with file, value and remedy) for whatever cannot be opened, and Cancelled. The
// warnings tell which settings of the dial the back end cannot play.
LoadedPatient load_patient(const OpenRequest& request, Job& job,
                           const DeformBackEnd& back_end = cpu_back_end());

}  // namespace hepatica
