// SPDX-License-Identifier: GPL-3.0-or-later
// The part of a CT that is drawn as a volume around the vessels: the bounding box of the liver with
// a margin, which leaves out table and arms, resampled to cubes of 1.25 mm and smoothed slightly,
// because shading shows noise more than a slice does. It is for display only, not for measurement.
#pragma once

#include "core/base/job.h"
#include "core/image/volume.h"
#include "core/patient/patient_case.h"

namespace hepatica {

// Returns Hounsfield units on at most about 256 voxels along each axis; the cubes are wider where
// the box is longer. The box is that of the liver in `organs` (organ_label) with 30 mm around it,
// or that of the patient's vessels with 50 mm where there is no liver, cut to the CT. Empty where
// there is neither, or where the box lies outside the CT. Thread-safe. Takes about a second and
// needs six bytes for each voxel of the CT in the box meanwhile. Throws Cancelled.
Volume ct_around_liver(const Volume& ct, const PatientCase& patient, const Mask& organs, Job& job);

}  // namespace hepatica
