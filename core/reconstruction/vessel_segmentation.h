// SPDX-License-Identifier: GPL-3.0-or-later
// From a contrast CT to the voxels of its hepatic vessels: the paper's multi-layer method (section
// II.A.1), a multi-scale vesselness as the modern comparison, and the default, which joins
// intensity with coherence along lines.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/base/job.h"
#include "core/image/volume.h"
#include "core/links/link_model.h"
#include "core/segmentation/segmentation_method.h"

namespace hepatica {

struct SegmentationOptions {
    SegmentationMethod method = SegmentationMethod::coherent;
    // Anything else than 0 is liver. Any grid; vessels may be carved out of it (it is closed).
    // Without one the liver is found (liver_region.h), and pieces of vessels outside of it, such as
    // those of a spleen that touches it, are left out.
    std::optional<Mask> liver;
    // Hounsfield window of the vessels; without one it follows from the image's own statistics.
    std::optional<std::pair<double, double>> window_hu;
    // Recursions of the Gaussian refinement (gaussian_refinement.h); 0 leaves the surface alone.
    int refinement_recursions = 0;
    // Edge of the cubic voxels that the work is done on, 0.3 to 1.5; 0 stands for 0.65.
    double spacing_mm = 0.0;
    // Chooses among more and fainter lines than would be believed without it; `coherent` without a
    // window only.
    std::optional<LinkModel> model;
};

// What the image says about itself, inside the liver.
struct ContrastStatistics {
    double parenchyma_hu = 0.0;  // median of the liver
    double noise_hu = 0.0;       // standard deviation of the tissue around its local level
    double vessel_hu = 0.0;      // median well inside vessels
    double contrast_hu() const { return vessel_hu - parenchyma_hu; }
};

struct Segmentation {
    // 0 background, else the number of an unknown system. On a grid that covers the liver with
    // cubic voxels and lies in the CT's frame.
    Mask mask;
    Mask liver;             // closed; same grid as the mask; where none was given, the one found
    FloatVolume intensity;  // CT resampled to that grid, in HU: for radii below the voxel
    Mask centreline;        // where the fast-marching fronts collide; multi_layer only, else empty
    ContrastStatistics statistics;
    // Where the portal trunk comes into what was segmented, if it was found outside of the liver.
    std::optional<Vec3> trunk_mm;
    int components = 0;                 // 26-connected pieces of the mask
    std::vector<std::string> warnings;  // for the user, such as a slice spacing above 1.5 mm
};

// Throws InputError where the CT shows no contrast between vessels and liver (naming what was
// measured), where no liver can be found, or an option is outside its range; Cancelled. Begins its
// own stages of the job. Same bytes for any number of threads.
Segmentation segment_vessels(const Volume& ct, const SegmentationOptions& options, Job& job);

}  // namespace hepatica
