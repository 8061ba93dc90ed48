// SPDX-License-Identifier: GPL-3.0-or-later
// Whether seeds lie where they can mean a vessel of the liver, asked before the long work begins.
#pragma once

#include <string>
#include <vector>

#include "core/base/vascular_system.h"
#include "core/image/volume.h"

namespace hepatica {

// Throws InputError, with the seed and the reach of the image, for a seed outside of it.
void require_seeds_in_image(const std::vector<VesselSeed>& seeds, const Grid& grid);

// Trunks leave the liver, but not far from it: throws InputError for a seed that lies more than
// 10 mm from it. `liver_place` names the liver mask.
void require_seeds_near_liver(const std::vector<VesselSeed>& seeds, const Mask& liver,
                              const std::string& liver_place);

}  // namespace hepatica
