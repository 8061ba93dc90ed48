// SPDX-License-Identifier: GPL-3.0-or-later
// Couinaud's segments of a patient's liver, kept true to his tree.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "core/base/job.h"
#include "core/patient/patient_case.h"

namespace hepatica {

// What of the organs is liver: all but the vena cava, tumours included. Empty where nothing is but
// tumours.
Mask liver_of(const Mask& organs);

// Makes `couinaud` anew from organs and tree, and says in `doubts`, where the patient has any, how
// sure it is; both without segments where there is no portal vein, or no liver about tumours.
// Nothing changes where the patient holds no organs (read without voxels). Reports progress in the
// present stage; throws Cancelled.
void label_segments(PatientCase& patient, Job& job);

// {"1": millilitres, ..., "8": ...} of a label map.
nlohmann::ordered_json segments_ml_json(const Mask& couinaud);

}  // namespace hepatica
