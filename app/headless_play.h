// SPDX-License-Identifier: GPL-3.0-or-later
// Plays a trainee's tour of the window without a window: look, pull a vessel, let go, inject, watch
// the front. Produces the pictures, curves and facts of a report.
#pragma once

#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <vector>

#include "app/album.h"
#include "core/base/job.h"
#include "core/patient/patient_case.h"
#include "core/scene/deform_back_end.h"

namespace hepatica {

struct HeadlessPlay {
    std::vector<AlbumPicture> pictures;
    // Steps, how many the body slept through, times of the others, forces.
    nlohmann::ordered_json simulation;
    nlohmann::ordered_json injection;  // the drug, its pressure, its masses
};

// Plays on the patient and writes the pictures and curves into `folder`, which must exist. Begins
// three stages of the job. Throws InputError where the folder cannot be written or the case has no
// body; Cancelled.
HeadlessPlay play_headless(std::shared_ptr<const PatientCase> patient,
                           const std::filesystem::path& folder, Job& job,
                           const DeformBackEnd& back_end = cpu_back_end());

}  // namespace hepatica
