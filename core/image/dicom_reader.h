// SPDX-License-Identifier: GPL-3.0-or-later
// A CT series from a DICOM folder, decoded by GDCM (JPEG, JPEG-LS, JPEG 2000, RLE included).
#pragma once

#include <filesystem>
#include <vector>

#include "core/base/job.h"
#include "core/image/dicom_slices.h"
#include "core/image/series_choice.h"
#include "core/image/volume.h"
#include "core/image/volume_reader.h"

namespace hepatica {

// The CT series that the caller asks for, see choose_series. Padding (0028,0120) becomes
// padding_value. For the rest see read_volume.
Volume read_dicom(const std::filesystem::path& folder, const SeriesWish& wish,
                  std::int16_t padding_value, Job& job, ReadRemarks& remarks);

// One slice in Hounsfield units, row by row; padding is not a number. Its geometry is not asked
// for. Throws InputError where its values cannot be trusted or decoded.
std::vector<double> slice_hu(const DicomSlice& slice);

}  // namespace hepatica
