// SPDX-License-Identifier: GPL-3.0-or-later
// The parameters of a reconstruction that its case keeps, as JSON.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

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

// What a person gave for a reconstruction, as far as its case tells.
struct GivenParts {
    bool liver_mask = false;
    bool vessel_mask = false;
    std::size_t tumour_masks = 0;  // how many
    std::optional<std::pair<double, double>> window_hu{};
    std::vector<VesselSeed> seeds{};
};

// Missing or malformed values count as not given.
GivenParts given_parts(const std::string& parameters_json);

// Reads the options that decide how a tree is made from voxels. Missing or malformed values take
// their defaults; malformed seeds are left out.
FromVoxelsOptions from_voxels_options(const std::string& parameters_json);

}  // namespace hepatica
