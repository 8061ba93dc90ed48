// SPDX-License-Identifier: GPL-3.0-or-later
// What of a patient's organs stands in the way of his vessels: his tumours, which they do not
// enter, and the liver, which what is in it does not leave. Rigid, and made of voxels: smooth
// surfaces as coarse as contact needs.
#pragma once

#include <memory>

#include "core/deform/body/obstacles.h"
#include "core/patient/patient_case.h"
#include "core/scene/scene_spec.h"

namespace hepatica {

// The liver, tumours included and tunnels of vessels closed, then each tumour by its number; those
// that there are. A cell of a surface is a tenth of a ball's diameter that has the organ's volume,
// from 1 to 4 mm.
std::vector<Obstacle> obstacles_in(const Mask& organs);

// Those that a scene asks for; null where it does not, or asks for what is known and nothing is.
// Throws InputError where it demands some and the case knows none, or cannot be read.
std::shared_ptr<const Obstacles> obstacles_for(const PatientCase& patient,
                                               const std::optional<ContactSpec>& contact);

}  // namespace hepatica
