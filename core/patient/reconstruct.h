// SPDX-License-Identifier: GPL-3.0-or-later
// The whole way from a CT to a body, as one job that can be watched and stopped:
// read, find the liver, resample, segment, refine, thin, unit width, tree, mesh.
#pragma once

#include <filesystem>
#include <optional>
#include <utility>
#include <vector>

#include "core/base/job.h"
#include "core/mesh/tetrahedralize.h"
#include "core/patient/patient_case.h"

namespace hepatica {

struct ReconstructOptions {
    std::filesystem::path ct;                            // DICOM folder or volume file
    std::optional<std::filesystem::path> liver_mask;     // nonzero = liver
    std::optional<std::filesystem::path> vessel_mask;    // nonzero = vessel: no segmentation
    std::optional<std::pair<double, double>> window_hu;  // vessels lie within; else found
    std::vector<Vec3> seeds_mm;                          // one or more per vascular system
    int refinement_recursions = 1;                       // Gaussian smoothing of the mask
    double spacing_mm = 0.0;                             // isotropic working grid; 0: chosen
    MeshOptions mesh;
};

// Counts that `hepatica-cli reconstruct --json` prints beside the case itself.
struct VoxelCounts {
    std::size_t voxels = 0;
    int components = 0;
    int tunnels = 0;
    int cavities = 0;
};
struct Reconstruction {
    PatientCase patient;
    VoxelCounts mask;
    VoxelCounts skeleton;
    int crowded_points = 0;  // skeleton voxels of degree > 2 next to another such voxel
    std::vector<StageTime> stages;
    std::vector<std::string> warnings;  // for the user: coarse slices, many components ...
};

// Throws InputError for whatever cannot be reconstructed (with file, value and remedy), Cancelled.
// Writes nothing: see write_case. Thread safety: may run on any thread.
Reconstruction reconstruct(const ReconstructOptions& options, Job& job);

}  // namespace hepatica
