// SPDX-License-Identifier: GPL-3.0-or-later
// A CT series from a DICOM folder, decoded by GDCM (JPEG, JPEG-LS, JPEG 2000, RLE included).
#pragma once

#include <filesystem>
#include <vector>

#include "core/base/job.h"
#include "core/image/dicom_series.h"
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

// A DICOM folder and the file in it that is meant, from what read_volume() takes: a folder, one
// file of a series, or a DICOMDIR; the file is empty where none is meant.
struct DicomPlace {
    std::filesystem::path folder, member;
};
DicomPlace dicom_place(const std::filesystem::path& path);

// The slices that read_volume() reads of `path` and `series`, in order, one of each place; an
// enhanced file stands for all of its frames and is alone then. Throws InputError as read_volume()
// does, and where `path` is no DICOM image.
OrderedSeries find_series(const std::filesystem::path& path, int series, Job& job);

// The CT series that the caller asks for, see choose_series. For the rest see read_volume.
Volume read_dicom(const std::filesystem::path& folder, const DicomWish& wish, Job& job,
                  ReadRemarks& remarks);

// The same of a slice that nobody has checked; its geometry is not asked for. Throws InputError,
// also where it holds several frames.
std::vector<double> slice_hu(const DicomSlice& slice);

}  // namespace hepatica
