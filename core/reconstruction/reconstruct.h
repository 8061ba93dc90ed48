// SPDX-License-Identifier: GPL-3.0-or-later
// The whole reconstruction from a CT to a body, as one cancellable job that reports progress: read,
// segment (in the liver, on a resampled grid), thin, unit width, tree, mesh.
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
    int series = 0;            // in the folder, numbered as by list_series(); 0: the best
    std::string name;          // name of the patient on the screen and in case.json
    std::optional<std::filesystem::path> liver_mask;     // nonzero = liver; on the CT's grid
                                                         // or a box of its voxels
    std::optional<std::filesystem::path> vessel_mask;    // replaces the segmentation; its labels
                                                         // are systems, see given_vessels.h
    std::vector<std::filesystem::path> tumour_masks;     // see tumours.h; needs a liver
    std::optional<std::pair<double, double>> window_hu;  // none: found in the image
    std::vector<VesselSeed> seeds;                       // one or more per vascular system
    std::vector<int> liver_labels;           // labels of the liver mask; empty: all that are not 0
    std::vector<VesselLabel> vessel_labels;  // labels of the vessel mask; see given_vessels.h
    // Gaps are bridged from this confidence on (gap_bridging.h), and the stretch is marked; others
    // are only offered.
    double bridge_confidence = BridgeOptions{}.confidence;
    SegmentationMethod method = SegmentationMethod::coherent;
    // The model that chooses among lines (link_model.h), for `coherent` without a window; none:
    // lines are accepted by their strength alone.
    std::optional<std::filesystem::path> model;
    // The model that offers branches among fainter lines where none chooses; none: none are
    // offered.
    std::optional<std::filesystem::path> offers;
    int refinement_recursions = 0;  // Gaussian smoothing of the mask (paper, II.A.2)
    ThinningMethod thinning = ThinningMethod::queue;
    double spacing_mm = 0.0;  // edge of the cubic working voxels, 0.3 to 1.5; 0: 0.65
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

// Number of stages that reconstruct() begins. A caller with stages of its own announces all
// together.
int stage_count(const ReconstructOptions& options);

// Called with the CT as soon as it is read, on the job's thread, so that it can be shown meanwhile.
using ImageRead = std::function<void(const std::shared_ptr<const Volume>& ct)>;

// Reconstructs a patient; writes no file (see write_case()). Throws InputError, with file, value
// and remedy, for whatever cannot be reconstructed; Cancelled. Thread-safe.
Reconstruction reconstruct(const ReconstructOptions& options, Job& job,
                           const ImageRead& image_read = {});

}  // namespace hepatica
