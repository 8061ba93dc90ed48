// SPDX-License-Identifier: GPL-3.0-or-later
// The whole way from a CT to a body, as one job that can be watched and stopped: read, segment (in
// the liver, on a resampled grid), thin, unit width, tree, mesh.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/base/job.h"
#include "core/mesh/tetrahedralize.h"
#include "core/patient/patient_case.h"
#include "core/reconstruction/from_voxels.h"
#include "core/reconstruction/given_vessels.h"
#include "core/reconstruction/vessel_segmentation.h"
#include "core/skeleton/thinning.h"

namespace hepatica {

struct ReconstructOptions {
    std::filesystem::path ct;  // DICOM folder or volume file
    int series = 0;            // of the folder, as list_series numbers them; 0: the best
    std::string name;          // what the patient shall be called on the screen and in case.json
    std::optional<std::filesystem::path> liver_mask;     // nonzero = liver; on the CT's grid
                                                         // or a box of its voxels
    std::optional<std::filesystem::path> vessel_mask;    // no segmentation is done; labels are
                                                         // systems, see given_vessels.h
    std::vector<std::filesystem::path> tumour_masks;     // see tumours.h; a liver must be known
    std::optional<std::pair<double, double>> window_hu;  // vessels lie within; else found
    std::vector<VesselSeed> seeds;                       // one or more per vascular system
    std::vector<int> liver_labels;           // of the liver mask; empty: all that are not 0
    std::vector<VesselLabel> vessel_labels;  // of the vessel mask; see given_vessels.h
    // Gaps in a vessel are bridged from this confidence on (see gap_bridging.h), and the stretch is
    // marked; the others are only offered.
    double bridge_confidence = BridgeOptions{}.confidence;
    SegmentationMethod method = SegmentationMethod::coherent;
    // What chooses among lines (link_model.h), for `coherent` without a window; none: lines are
    // believed by their strength alone.
    std::optional<std::filesystem::path> model;
    int refinement_recursions = 0;  // Gaussian smoothing of the mask (paper, II.A.2)
    ThinningMethod thinning = ThinningMethod::queue;
    double spacing_mm = 0.0;  // isotropic working grid; 0: chosen from the CT
    MeshOptions mesh{.target_tetrahedra = 20000};
};

struct Reconstruction {
    PatientCase patient;
    VoxelChecks checks;
    std::vector<StageTime> stages;
    std::vector<std::string> warnings;  // for the user: coarse slices, many components ...
    // The first so many are of the image: other vessels change nothing of what they say.
    std::size_t warnings_of_image = 0;
};

// How many stages of its job it begins. A caller that begins others announces them all together.
int stage_count(const ReconstructOptions& options);

// Told of the CT as soon as it is read, on the job's thread: whoever waits can look at it.
using ImageRead = std::function<void(const std::shared_ptr<const Volume>& ct)>;

// Throws InputError for whatever cannot be reconstructed (with file, value and remedy), Cancelled.
// Writes nothing: see write_case. Thread safety: may run on any thread.
Reconstruction reconstruct(const ReconstructOptions& options, Job& job,
                           const ImageRead& image_read = {});

}  // namespace hepatica
