// SPDX-License-Identifier: GPL-3.0-or-later
// A binary DICOM segmentation (PS3.3 A.51) by DCMTK: a frame for each segment and slice in which it
// has pixels. Patient, study and frame of reference are those of the CT, of which it becomes a
// series.
#pragma once

#include <filesystem>
#include <string>

#include "app/dicom_segmentation/order.h"
#include "app/dicom_segmentation/source_slices.h"

namespace hepatica::dicom_segmentation {

// `version` is the program's. Throws Refusal where the source lacks what a segmentation needs, the
// order is cut off or the file cannot be written.
void write_segmentation(Order& order, SourceSlices& source, const std::string& version,
                        const std::filesystem::path& file);

}  // namespace hepatica::dicom_segmentation
