// SPDX-License-Identifier: GPL-3.0-or-later
// Segments the hepatic vessels in a contrast CT, by one of three methods: the paper's multi-layer
// method (section II.A.1), a multi-scale vesselness, and the default, which combines intensity with
// coherence along lines.
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
#include "core/tree/extraction/gap_bridging.h"

namespace hepatica {

struct SegmentationOptions {
    SegmentationMethod method = SegmentationMethod::coherent;
    // Liver where not 0, on any grid; vessels may be missing from it, because it is closed. Without
    // one the liver is found (liver_region.h), and vessels outside it, such as those of a touching
    // spleen, are left out.
    std::optional<Mask> liver;
    // Hounsfield window of the vessels; none: from the image's own statistics.
    std::optional<std::pair<double, double>> window_hu;
    // Recursions of the Gaussian refinement (gaussian_refinement.h); 0 leaves the surface as it is.
    int refinement_recursions = 0;
    // Edge of the cubic working voxels, 0.3 to 1.5; 0 means 0.65.
    double spacing_mm = 0.0;
    // Chooses among more and fainter lines than are accepted without it; for `coherent` without a
    // window only.
    std::optional<LinkModel> model;
    // Without `model`: offers branches among more and fainter lines, likewise.
    std::optional<LinkModel> offers;
};

// Contrast of the image inside the liver.
struct ContrastStatistics {
    double parenchyma_hu = 0.0;  // median of the liver
    double noise_hu = 0.0;       // standard deviation of the tissue around its local mean
    double vessel_hu = 0.0;      // median well inside vessels
    double contrast_hu() const { return vessel_hu - parenchyma_hu; }
};

struct Segmentation {
    // 0 background, else the number of the unknown system. The grid covers the liver with cubic
    // voxels in the CT's frame.
    Mask mask;
    Mask liver;             // closed, given or found; on the mask's grid
    FloatVolume intensity;  // CT resampled to that grid, in HU
    Mask centreline;        // where the fast-marching fronts collide; multi_layer only, else empty
    ContrastStatistics statistics;
    // Where the portal trunk enters the segmented region, if it was found outside the liver.
    std::optional<Vec3> trunk_mm;
    std::vector<Bridge> offered;        // branches that may be vessels
    int components = 0;                 // 26-connected pieces of the mask
    std::vector<std::string> warnings;  // for the user, such as on slice spacings above 1.5 mm
};

// Segments the vessels. Begins its own stages of the job. The same bytes for any number of threads.
// Throws InputError where the CT shows no contrast between vessels and liver (with the measured
// values), where noise is taken for vessels (plausible_skeleton.h), where no liver can be found, or
// where an option is outside its range; Cancelled.
Segmentation segment_vessels(const Volume& ct, const SegmentationOptions& options, Job& job);

}  // namespace hepatica
