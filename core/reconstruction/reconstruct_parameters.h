// SPDX-License-Identifier: GPL-3.0-or-later
// The parameters of a reconstruction that its case keeps, as JSON.
#pragma once

#include <optional>
#include <string>

#include "core/reconstruction/reconstruct.h"

namespace hepatica {

// Whether a model can choose lines, or offer some, with these options.
bool takes_models(const ReconstructOptions& options);

// The options as one JSON object. Of the masks it says only whether they were given, because their
// paths may hold a patient's name.
std::string parameters_json(const ReconstructOptions& options);

// Adds the place where the portal trunk was seen to enter, if it was. The tree begins farther along
// the vessel and could not be made again from its voxels without that place.
void keep_portal_trunk(const std::optional<Vec3>& trunk_mm, std::string& parameters_json);

// Keeps whether the given vessel mask said which vessel is of which system: those of one number are
// told apart, when the case is remade as well.
void keep_systems_given(bool given, std::string& parameters_json);

// Reads the options that decide how a tree is made from voxels. Missing or malformed values take
// their defaults; malformed seeds are left out.
FromVoxelsOptions from_voxels_options(const std::string& parameters_json);

}  // namespace hepatica
