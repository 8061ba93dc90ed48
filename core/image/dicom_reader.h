// SPDX-License-Identifier: GPL-3.0-or-later
// Reads a CT series from a DICOM folder. Compressed pixels (JPEG, JPEG-LS, JPEG 2000) are decoded
// by GDCM, RLE by dicom_rle.h.
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

// One slice in Hounsfield units, row by row; NaN at padding. Throws InputError that names the file
// where its pixels are damaged or in an unsupported format. Thread-safe.
std::vector<double> read_pixels(const DicomSlice& slice);

// The options of read_volume() and read_mask() for a series.
struct DicomWish {
    SeriesWish series;
    // Value of padding (0028,0120) and of voxels that were not scanned.
    std::int16_t padding_value = 0;
    BetweenPixels between = BetweenPixels::linear;  // for straightening a tilted gantry
};

// The DICOM folder and the selected file in it, from a path as read_volume() takes it: a folder,
// one file of a series, or a DICOMDIR. `member` is empty if no file is selected.
struct DicomPlace {
    std::filesystem::path folder, member;
};
DicomPlace dicom_place(const std::filesystem::path& path);

// The slices that read_volume() reads for `path` and `series`, in order, one per position. An
// enhanced file represents all its frames; it is then returned unsplit and unordered. Throws
// InputError as read_volume() does, and where `path` is not a DICOM image; Cancelled.
OrderedSeries find_series(const std::filesystem::path& path, int series, Job& job);

// The CT series that the caller asks for, see choose_series(). For the rest see read_volume().
Volume read_dicom(const std::filesystem::path& folder, const DicomWish& wish, Job& job,
                  ReadRemarks& remarks);

// read_pixels() for a slice that has not been checked; its geometry is not needed. Throws
// InputError, also where the slice holds several frames.
std::vector<double> slice_hu(const DicomSlice& slice);

}  // namespace hepatica
