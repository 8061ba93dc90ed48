// SPDX-License-Identifier: GPL-3.0-or-later
// What a DICOM folder holds: one record per CT slice, read from the headers alone.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/base/job.h"
#include "core/base/vector.h"
#include "core/image/dicom_header.h"
#include "core/image/volume_reader.h"

namespace hepatica {

struct DicomSlice {
    std::filesystem::path file;        // as the user is told of it
    std::filesystem::path pixel_file;  // that its pixels are read from: the same, but of a frame
    std::string series_key;            // equal for slices of one series
    std::string description;           // of the series, for the user
    std::string modality;              // "CT", "MR" ...; may be blank
    std::string kernel;           // of the CT's reconstruction, as its maker calls it; may be blank
    std::string image_type;       // ORIGINAL\\PRIMARY\\AXIAL ...
    bool contrast_agent = false;  // one is named, or told of
    std::string acquisition;      // its number; may be blank
    // Why the slice's values cannot be read as Hounsfield units ("" where they can): found in the
    // header, told only where the slice belongs to the series that is read.
    std::string problem;
    bool localizer = false;     // a scout view
    bool enhanced = false;      // of a kind whose frames SplitFrames makes slices of
    bool segmentation = false;  // one of these: see dicom_segmentation.h
    int frames = 1;
    int rows = 0;
    int columns = 0;
    bool has_geometry = false;  // position, orientation and pixel spacing are there and are numbers
    Vec3 position_mm = Vec3::Zero();  // centre of the first pixel, LPS
    // Of each frame of an enhanced file; empty where it does not give one for each.
    std::vector<Vec3> frame_positions_mm;
    Vec3 row_axis = Vec3::Zero();      // along a row, towards the next column
    Vec3 column_axis = Vec3::Zero();   // down a column, towards the next row
    double row_spacing_mm = 0.0;       // between rows
    double column_spacing_mm = 0.0;    // between columns
    double stated_spacing_mm = 0.0;    // between slices (0018,0088); 0 where it is not stated
    double stated_tilt_degrees = 0.0;  // of the gantry; positions and orientations are believed

    // How the pixels are stored.
    int bits_allocated = 0;
    int bits_stored = 0;
    int high_bit = 0;  // of the stored ones, counted from 0
    bool is_signed = false;
    int samples_per_pixel = 1;
    bool big_endian = false;
    bool compressed = false;
    std::uint64_t pixel_offset = 0;
    std::uint64_t pixel_bytes = 0;
    std::string transfer_syntax;
    std::vector<FileRange> fragments;
    std::uint64_t deflated_at = 0;  // see DicomHeader
    bool inverted_display = false;  // MONOCHROME1: low values are shown bright
    bool has_rescale = true;
    // Stored values within these limits, both included, are padding and no measurement.
    std::optional<std::pair<double, double>> padding;
    double slope = 1.0;  // HU = slope * stored + intercept
    double intercept = 0.0;

    Vec3 normal() const;
    double along_normal_mm() const { return position_mm.dot(normal()); }
};

// Of one file; nothing where it is no DICOM file, holds no image or its header is damaged.
std::optional<DicomSlice> read_dicom_slice(const std::filesystem::path& file);

// Looks at every file below `folder`; what is not a DICOM image is passed over, and what cannot be
// listed or opened is named in `remarks`. Reports the first half of the stage's progress.
std::vector<DicomSlice> find_dicom_slices(const std::filesystem::path& folder, Job& job,
                                          ReadRemarks& remarks);

}  // namespace hepatica
