// SPDX-License-Identifier: GPL-3.0-or-later
// A CT series from a DICOM folder, decoded by GDCM (JPEG, JPEG-LS, JPEG 2000, RLE included).
#pragma once

#include <filesystem>
#include <vector>

#include "core/base/job.h"
#include "core/image/dicom_slices.h"
#include "core/image/dicom_stack.h"
#include "core/image/series_choice.h"
#include "core/image/volume.h"
#include "core/image/volume_reader.h"

namespace hepatica {

// One slice in Hounsfield units, row by row; NaN where it is padded. Throws InputError that names
// the file where its pixels are damaged or of a kind that is not read.
std::vector<double> read_pixels(const DicomSlice& slice);

// What read_volume and read_mask want of a series.
struct DicomWish {
    SeriesWish series;
    std::int16_t padding_value = 0;  // what padding (0028,0120) becomes, and what was not scanned
    BetweenPixels between = BetweenPixels::linear;  // where a tilted gantry is put upright
};

// The CT series that the caller asks for, see choose_series. For the rest see read_volume.
Volume read_dicom(const std::filesystem::path& folder, const DicomWish& wish, Job& job,
                  ReadRemarks& remarks);

// The same of a slice that nobody has checked; its geometry is not asked for. Throws InputError,
// also where it holds several frames.
std::vector<double> slice_hu(const DicomSlice& slice);

}  // namespace hepatica
