// SPDX-License-Identifier: GPL-3.0-or-later
// Writes a case's vessels and organs as a segmentation: of DICOM, for archives and other viewers,
// or in the file that 3D Slicer opens.
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

// Writes the same segments, numbered from 1 in that order, as a .seg.nrrd (write_segmentation() in
// volume_writer.h) on the CT's grid, without a CT and without the patient's name. A voxel takes the
// value of the case's voxel that contains its centre, and belongs to one segment: where a vessel
// lies in an organ it belongs to the vessel. Begins one stage. Throws Cancelled, and InputError
// where the case has no voxels or no usable grid of its CT, and as write_segmentation() does.
void write_case_labels(const PatientCase& patient, const std::filesystem::path& file, Job& job);

}  // namespace hepatica
