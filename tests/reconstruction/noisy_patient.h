// SPDX-License-Identifier: GPL-3.0-or-later
// A small synthetic patient with so much noise that the faintest vessels are not believed.
#pragma once

#include "core/patient/patient_case.h"
#include "core/phantom/phantom.h"
#include "core/reconstruction/vessel_segmentation.h"

namespace hepatica::testing_support {

struct NoisyPatient {
    Phantom truth;
    Mask found;   // numbers of an unknown system, as the segmentation finds them
    Mask organs;  // organ_label
};

inline NoisyPatient noisy_patient() {
    Job job;
    PhantomOptions options;
    options.dims = {96, 96, 64};
    options.spacing_mm = Vec3(1.8, 1.8, 2.0);
    options.generations = 5;
    options.noise_hu = 14.0;
    NoisyPatient patient{make_phantom(options, job), {}, {}};
    SegmentationOptions search;
    search.liver = patient.truth.liver;
    patient.found = segment_vessels(patient.truth.ct, search, job).mask;
    patient.organs = patient.truth.liver;
    for (std::uint8_t& voxel : patient.organs.voxels) voxel = voxel ? organ_label::liver : 0;
    return patient;
}

}  // namespace hepatica::testing_support
