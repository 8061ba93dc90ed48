// SPDX-License-Identifier: GPL-3.0-or-later
// The part of a CT that is drawn as a volume around the vessels: the liver's box with a margin, so
// that neither table nor arms are there, in cubes of 1.25 mm, slightly smoothed, because light
// on a surface shows noise more than a slice does. It is no measure of anything.
#pragma once

#include "core/base/job.h"
#include "core/image/volume.h"
#include "core/patient/patient_case.h"

namespace hepatica {

// Hounsfield units, at most 256 voxels along each axis: wider cubes where the box is longer. The
// box is that of the liver in `organs` (organ_label), or of the patient's vessels where there is
// none, and what of it the CT holds. Empty where there are neither, or none of it is in the CT. Any
// thread. Costs about a second, and six bytes for each voxel of the CT within the box for as long.
// Throws Cancelled.
Volume ct_around_liver(const Volume& ct, const PatientCase& patient, const Mask& organs, Job& job);

}  // namespace hepatica
