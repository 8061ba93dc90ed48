// SPDX-License-Identifier: GPL-3.0-or-later
// The organs that act as obstacles: tumours, which vessels do not enter, and the liver, which the
// vessels inside do not leave. They are rigid, with smooth surfaces made from voxels, as coarse as
// contact needs.
#pragma once

#include <memory>

#include "core/deform/body/obstacles.h"
#include "core/patient/patient_case.h"
#include "core/scene/scene_spec.h"

namespace hepatica {

// The liver, including tumours and with tunnels of vessels closed, then each tumour by its number,
// as far as there are any. The cells of a surface are a tenth of the diameter of a ball with the
// organ's volume, limited to 1 to 4 mm.
std::vector<Obstacle> obstacles_in(const Mask& organs);

// The obstacles that a scene asks for; null where it asks for none, or for the known ones and there
// are none. Throws InputError where it requires some and the case has none, or cannot be read.
std::shared_ptr<const Obstacles> obstacles_for(const PatientCase& patient,
                                               const std::optional<ContactSpec>& contact);

}  // namespace hepatica
