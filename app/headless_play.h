// SPDX-License-Identifier: GPL-3.0-or-later
// The tour that a trainee would make at the window, played without one: look, pull a vessel, let
// go, inject, watch the front. Leaves pictures, curves and the facts behind a report.
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
    // Steps, how many of them the body slept through, times of the others, forces.
    nlohmann::ordered_json simulation;
    nlohmann::ordered_json injection;  // the drug, pressure, volumes
};

// Plays on the patient and writes the pictures and curves into `folder`, which must exist.
// Begins three stages of the job. Throws InputError (a folder that cannot be written, a case
// without a body), Cancelled.
HeadlessPlay play_headless(std::shared_ptr<const PatientCase> patient,
                           const std::filesystem::path& folder, Job& job,
                           const DeformBackEnd& back_end = cpu_back_end());

}  // namespace hepatica
