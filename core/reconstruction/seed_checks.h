// SPDX-License-Identifier: GPL-3.0-or-later
// Checks, before the long work begins, that seeds can lie in a vessel of the liver.
#pragma once

#include <string>
#include <vector>

#include "core/base/vascular_system.h"
#include "core/image/volume.h"

namespace hepatica {

// Throws InputError, with the seed and the extent of the image, for a seed outside it.
void require_seeds_in_image(const std::vector<VesselSeed>& seeds, const Grid& grid);

// Throws InputError for a seed more than 10 mm from the liver: trunks leave the liver, but not far.
// `liver_place` names the liver mask.
void require_seeds_near_liver(const std::vector<VesselSeed>& seeds, const Mask& liver,
                              const std::string& liver_place);

}  // namespace hepatica
