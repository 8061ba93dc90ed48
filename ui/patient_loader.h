// SPDX-License-Identifier: GPL-3.0-or-later
// From what the user opened (a case, a CT, a tree, the built-in patient) to a patient that can be
// played with. One cancellable job; no toolkit.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/patient/patient_case.h"
#include "core/reconstruction/reconstruct.h"
#include "ui/simulation.h"
#include "ui/surface_anatomy.h"

namespace hepatica {

struct OpenRequest {
    bool built_in = false;           // the synthetic patient; the rest is not read
    ReconstructOptions reconstruct;  // `ct` is the path: case folder, DICOM folder, volume, or tree
};

struct LoadedPatient {
    std::string title;
    std::shared_ptr<const PatientCase> patient;
    SurfaceAnatomy anatomy;
    std::vector<double> flow_shares;         // per segment, see vessel_flow.h; may be empty
    std::unique_ptr<Simulation> simulation;  // running
    std::vector<std::string> warnings;
    bool on_disk = false;          // opened from a case folder: nothing to save
    std::filesystem::path folder;  // the case that holds the voxels which `patient` lacks; or none
};

// A patient that is in memory, with its simulation running.
LoadedPatient play(std::shared_ptr<const PatientCase> patient, Job& job);

// Throws InputError for whatever cannot be opened (with file, value and remedy), Cancelled.
LoadedPatient load_patient(const OpenRequest& request, Job& job);

}  // namespace hepatica
