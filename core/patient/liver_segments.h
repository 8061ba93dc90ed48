// SPDX-License-Identifier: GPL-3.0-or-later
// Couinaud's segments of a patient's liver, kept consistent with its tree.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "core/base/job.h"
#include "core/patient/patient_case.h"

namespace hepatica {

// The liver in a map of organs: everything but the vena cava, tumours included, as 0 and 1. Empty
// where no voxel is labelled liver.
Mask liver_of(const Mask& organs);

// Computes `couinaud` from organs and tree, and its doubts where the patient has any. Both stay
// empty where there is no portal vein or no liver. Changes nothing where the patient holds no
// organs (read without voxels). Reports progress in the present stage; throws Cancelled.
void label_segments(PatientCase& patient, Job& job);

// The volumes of a label map: {"1": millilitres, ..., "8": ...}.
nlohmann::ordered_json segments_ml_json(const Mask& couinaud);

}  // namespace hepatica
