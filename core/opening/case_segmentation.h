// SPDX-License-Identifier: GPL-3.0-or-later
// A case's vessels and organs as a DICOM segmentation of its CT, for the archive and other viewers.
#pragma once

#include <filesystem>
#include <string>

#include "core/base/job.h"
#include "core/patient/patient_case.h"

namespace hepatica {

// Each system of vessels, the liver, the vena cava and each tumour that the case knows; the voxels
// are those of the case (they change by painting and Rebuild, not by other corrections of the
// tree). `ct` is the DICOM folder of the CT that the case was made of, which is read to make sure
// of it; the file names the patient as that CT does. Begins two stages. Throws Cancelled;
// InputError where the case has no voxels, the CT is another one, and as write_dicom_segmentation()
// does.
void write_case_segmentation(const PatientCase& patient, const std::filesystem::path& ct,
                             const std::filesystem::path& file, const std::string& program_version,
                             Job& job);

}  // namespace hepatica
