// SPDX-License-Identifier: GPL-3.0-or-later
// From a contrast CT to the voxels of its hepatic vessels: the paper's multi-layer method (section
// II.A.1), a multi-scale vesselness as the modern comparison, and the two together.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/base/job.h"
#include "core/image/volume.h"

namespace hepatica {

enum class SegmentationMethod {
    multi_layer,  // 2-D cross-sections, layer by layer, assembled along their centreline
    vesselness,   // 3-D multi-scale Hessian, hysteresis, growth
    combined,     // intensity and vesselness as one likelihood: the default
};

// A point inside one vascular system. Systems are numbered from 1 (say 1 portal vein, 2 hepatic
// veins, 3 artery); several seeds may name the same system.
struct VesselSeed {
    Vec3 position_mm = Vec3::Zero();
    std::uint8_t system = 1;
};

struct SegmentationOptions {
    SegmentationMethod method = SegmentationMethod::combined;
    // Anything else than 0 is liver. Any grid; vessels may be carved out of it (it is closed).
    // Without one the liver is found (liver_region.h).
    std::optional<Mask> liver;
    // Hounsfield window of the vessels; without one it follows from the image's own statistics.
    std::optional<std::pair<double, double>> window_hu;
    // With seeds only what is connected to one of them is kept, and labelled with its system.
    std::vector<VesselSeed> seeds;
    // Recursions of the Gaussian refinement (gaussian_refinement.h); 0 leaves the surface alone.
    int refinement_recursions = 1;
    // Edge of the isotropic voxels that the work is done on, at most 1.5; 0 picks it from the CT.
    double spacing_mm = 0.0;
};

// What the image says about itself, inside the liver.
struct ContrastStatistics {
    double parenchyma_hu = 0.0;  // mode of the liver tissue
    double noise_hu = 0.0;       // standard deviation of the noise in one voxel of the CT
    double vessel_hu = 0.0;      // mean of the voxels well inside vessels
    double contrast_hu() const { return vessel_hu - parenchyma_hu; }
};

struct Segmentation {
    // 0 background, else the system's number (1 where no seed was given). On an isotropic grid that
    // covers the liver and lies in the CT's frame.
    Mask mask;
    Mask liver;             // closed; same grid as the mask
    FloatVolume intensity;  // CT resampled to that grid, in HU: for radii below the voxel
    Mask centreline;        // where the fast-marching fronts collide; multi_layer only, else empty
    ContrastStatistics statistics;
    int components = 0;                 // 26-connected pieces of the mask
    std::vector<std::string> warnings;  // for the user, such as a slice spacing above 1.5 mm
};

// Throws InputError where the CT shows no contrast between vessels and liver (naming what was
// measured), where no liver can be found, or where a seed lies outside it; Cancelled. Progress and
// cancellation through the job. Same bytes for any number of threads.
Segmentation segment_vessels(const Volume& ct, const SegmentationOptions& options, Job& job);

// Relabels the piece of a system around a seed: the connected voxels of the system found at
// the seed that are no nearer, along the vessels, to any seed of their own system than to this one.
// Returns the number of voxels that changed hands. One step of the correction of an overlap of two
// systems that touch. Throws InputError if the seed lies in no vessel.
std::size_t reassign_overlap(Mask& systems, const std::vector<VesselSeed>& seeds,
                             const VesselSeed& correction);

}  // namespace hepatica
