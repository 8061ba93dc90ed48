// SPDX-License-Identifier: GPL-3.0-or-later
// Writes a case's vessels and organs as a DICOM segmentation of its CT, for archives and other
// viewers.
#pragma once

#include <filesystem>
#include <string>

#include "core/base/job.h"
#include "core/patient/patient_case.h"

namespace hepatica {

// Writes one segment for each vascular system, the liver, the vena cava and each tumour of the
// case. The voxels are those of the case, which change by painting and Rebuild, but not by other
// corrections of the tree. `ct` is the DICOM folder of the CT that the case was made from; it is
// read to check that it is the same, and the file takes the patient's name from it. Begins two
// stages, and more where the CT is not the first series that is tried. Throws Cancelled, and
// InputError where the case has no voxels, the CT is another one, or write_dicom_segmentation()
// throws it.
void write_case_segmentation(const PatientCase& patient, const std::filesystem::path& ct,
                             const std::filesystem::path& file, const std::string& program_version,
                             Job& job);

}  // namespace hepatica
