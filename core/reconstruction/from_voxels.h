// SPDX-License-Identifier: GPL-3.0-or-later
// Makes a case from the voxels of its vessels: skeleton, tree with systems, gaps and doubts, the
// liver's segments, and the body.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/base/job.h"
#include "core/mesh/tetrahedralize.h"
#include "core/patient/patient_case.h"
#include "core/skeleton/thinning.h"

namespace hepatica {

struct FromVoxelsOptions {
    std::vector<VesselSeed> seeds;
    std::vector<Vec3> kept_mm;  // see TreeOptions
    // True: systems are told apart by anatomy and seeds; false: the voxels hold their systems
    // already.
    bool find_systems = true;
    const Mask* systems_before = nullptr;  // see TreeOptions
    double bridge_confidence = BridgeOptions{}.confidence;
    ThinningMethod thinning = ThinningMethod::queue;
    std::optional<Vec3> portal_trunk_mm;  // where the trunk enters, if that is known
    bool shorten_trunk = false;           // see TreeOptions
    Doubts of_image{};                    // contrast, noise and spacing
};

// Counts that describe the quality of the voxels; displayed, not kept in the case.
struct VoxelCounts {
    std::size_t voxels = 0;
    long long components = 0;
    long long tunnels = 0;
    long long cavities = 0;
};

struct VoxelChecks {
    VoxelCounts mask;
    VoxelCounts skeleton;
    std::size_t crowded_points = 0;  // skeleton voxels of degree > 2 next to another such voxel
};

// Fills skeleton, tree, gaps and doubts of a case that holds mask and organs. Cavities of the mask
// are filled, and it takes the systems of the tree. The tree may come out empty. Begins four
// stages. Throws InputError, Cancelled.
VoxelChecks make_tree(const FromVoxelsOptions& options, const Volume& ct, PatientCase& patient,
                      std::vector<std::string>& warnings, Job& job);
inline constexpr int make_tree_stages = 4;

// Divides the liver into segments, appends the doubts to `warnings`, and makes mesh and surface.
// The patient keeps the warnings without the doubts, none of them as of the image.
// Begins one stage. Throws InputError, Cancelled.
void make_body(const MeshOptions& options, PatientCase& patient, std::vector<std::string>& warnings,
               Job& job);
inline constexpr int make_body_stages = 1;

}  // namespace hepatica
