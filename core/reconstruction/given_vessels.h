// SPDX-License-Identifier: GPL-3.0-or-later
// Vessels that somebody has drawn already: a mask or a label map, whose labels become the numbers
// of vascular systems (vascular_system.h).
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/job.h"
#include "core/base/vascular_system.h"
#include "core/image/volume.h"

namespace hepatica {

// A label of a vessel mask and the system that it stands for.
struct VesselLabel {
    int label = 1;
    VascularSystem system = VascularSystem::unknown;
};

// The labels of a mask as systems. Labels that are named become what they are named, the others
// background. Without names: a single label, whatever its number, is vessels of an unknown system;
// several labels are read as numbers of systems, and `warnings` says so.
// Throws InputError, naming `place`, where one of several labels is no system's number, or where
// no voxel is left.
Mask systems_of_labels(const LabelMap& labels, const std::vector<VesselLabel>& names,
                       const std::string& place, std::vector<std::string>& warnings);

// The vessels of a file on the CT's grid or on a box of its voxels, cut to what they fill with a
// margin. Throws InputError as above, and where the file cannot be read or does not fit; Cancelled.
Mask read_given_vessels(const std::filesystem::path& file, const std::vector<VesselLabel>& names,
                        const Grid& ct_grid, std::vector<std::string>& warnings, Job& job);

}  // namespace hepatica
