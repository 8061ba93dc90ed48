// SPDX-License-Identifier: GPL-3.0-or-later
// What a case keeps of the options that it was made with.
#pragma once

#include <optional>
#include <string>

#include "core/reconstruction/reconstruct.h"

namespace hepatica {

// One JSON object. Of the masks it says only whether they were given: their paths may hold a
// patient's name.
std::string parameters_json(const ReconstructOptions& options);

// Adds where the portal trunk was seen to come in, if it was: the tree begins farther on, and could
// not be made again from its voxels without that place.
void keep_portal_trunk(const std::optional<Vec3>& trunk_mm, std::string& parameters_json);

// What of them decides how a tree is made of voxels. Of what the object does not hold, or not as it
// should, the usual; seeds that make no sense are left out.
FromVoxelsOptions from_voxels_options(const std::string& parameters_json);

}  // namespace hepatica
