// SPDX-License-Identifier: GPL-3.0-or-later
// Writes a binary DICOM segmentation (PS3.3 A.51) with DCMTK: one frame for each segment and slice
// with pixels. Patient, study and frame of reference are those of the CT; the segmentation becomes
// a new series of that study.
#pragma once

#include <filesystem>
#include <string>

#include "app/dicom_segmentation/order.h"
#include "app/dicom_segmentation/source_slices.h"

namespace hepatica::dicom_segmentation {

// `version`: the program's version. Throws Refusal where the source lacks required values, the
// order is truncated, or the file cannot be written.
void write_segmentation(Order& order, SourceSlices& source, const std::string& version,
                        const std::filesystem::path& file);

}  // namespace hepatica::dicom_segmentation
