// SPDX-License-Identifier: GPL-3.0-or-later
// Vessels given as a mask or label map, whose labels become numbers of vascular systems
// (vascular_system.h).
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

// Turns the labels of a mask into systems. With `names`, labels that are named become their system
// and all others background. Without names, a single label means vessels of an unknown system, and
// several labels are read as numbers of systems, which `warnings` then mentions. Throws InputError,
// naming `place`, where one of several labels is no system's number, or where no voxel is left;
// Cancelled.
Mask systems_of_labels(const LabelMap& labels, const std::vector<VesselLabel>& names,
                       const std::string& place, std::vector<std::string>& warnings,
                       const Job& job = Job());

// Reads the vessels of a file on the CT's grid or on a box of its voxels, cut to the vessels with 5
// mm around them. Begins one stage. Throws InputError as above and where the file cannot be read or
// does not fit; Cancelled.
Mask read_given_vessels(const std::filesystem::path& file, const std::vector<VesselLabel>& names,
                        const Grid& ct_grid, std::vector<std::string>& warnings, Job& job);

}  // namespace hepatica
