// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/patient/built_in_patient.h"

#include "core/image/volume_writer.h"

namespace hepatica {

BuiltInPatient reconstruct_built_in(const std::filesystem::path& folder, Job& job) {
    BuiltInPatient patient;
    patient.truth = make_phantom(PhantomOptions{}, job);
    ReconstructOptions options;
    options.ct = folder / "ct.nii.gz";
    options.liver_mask = folder / "liver.nii.gz";
    write_nifti(options.ct, patient.truth.ct);
    write_nifti(*options.liver_mask, patient.truth.liver);
    patient.reconstruction = reconstruct(options, job);
    return patient;
}

}  // namespace hepatica
