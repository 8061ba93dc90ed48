// SPDX-License-Identifier: GPL-3.0-or-later
// The contents of a DICOM folder: one record per slice, read from the headers alone.
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
    std::filesystem::path file;        // the name shown to the user
    std::filesystem::path pixel_file;  // the file with the pixels: the same, except for a frame
    std::string series_key;            // equal for slices of one series
    std::string description;           // of the series, for the user
    std::string modality;              // "CT", "MR" ...; may be blank
    std::string kernel;           // of the CT's reconstruction, in the maker's terms; may be blank
    std::string image_type;       // ORIGINAL\\PRIMARY\\AXIAL ...
    bool contrast_agent = false;  // an agent is named, or its sequence is not empty
    std::string acquisition;      // acquisition number; may be blank
    // Why the slice's values cannot be read as Hounsfield units; "" if they can. Found in the
    // header, reported only if the slice belongs to the series that is read.
    std::string problem;
    bool localizer = false;     // a scout view
    bool enhanced = false;      // multi-frame: SplitFrames makes slices of its frames
    bool segmentation = false;  // a DICOM segmentation: see dicom_segmentation.h
    int frames = 1;
    int rows = 0;
    int columns = 0;
    bool has_geometry = false;        // position, orientation and pixel spacing are valid
    Vec3 position_mm = Vec3::Zero();  // centre of the first pixel, LPS
    // Positions of all frames of an enhanced file; empty if the file does not state one for each.
    std::vector<Vec3> frame_positions_mm;
    Vec3 row_axis = Vec3::Zero();      // along a row, towards the next column
    Vec3 column_axis = Vec3::Zero();   // down a column, towards the next row
    double row_spacing_mm = 0.0;       // between rows
    double column_spacing_mm = 0.0;    // between columns
    double stated_spacing_mm = 0.0;    // between slices (0018,0088); 0 if not stated
    double stated_tilt_degrees = 0.0;  // of the gantry; not used for the geometry

    // The storage of the pixels.
    int bits_allocated = 0;
    int bits_stored = 0;
    int high_bit = 0;  // highest stored bit, counted from 0
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
    // Stored values within these limits, both included, are padding and not measurements.
    std::optional<std::pair<double, double>> padding;
    double slope = 1.0;  // HU = slope * stored + intercept
    double intercept = 0.0;

    // Unit normal of the slice: row_axis x column_axis.
    Vec3 normal() const;
    double along_normal_mm() const { return position_mm.dot(normal()); }
    // From a voxel to the next one along a row, down a column and, slice_spacing_mm away, along the
    // normal: the columns of the matrix.
    Mat3 steps_mm(double slice_spacing_mm) const;
};

// The record of one file; nothing if it is not a DICOM file, holds no image or its header is
// damaged.
std::optional<DicomSlice> read_dicom_slice(const std::filesystem::path& file);

// All slices below `folder`. Files that are not DICOM images are skipped; files and folders that
// cannot be opened are named in `remarks`. Reports the first half of the stage's progress. Throws
// InputError where the folder cannot be opened, is empty or holds no DICOM image; Cancelled.
std::vector<DicomSlice> find_dicom_slices(const std::filesystem::path& folder, Job& job,
                                          ReadRemarks& remarks);

}  // namespace hepatica
