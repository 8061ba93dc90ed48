// SPDX-License-Identifier: GPL-3.0-or-later
// Writes images to disk in formats that other programs open. Files and folders appear complete or
// not at all, and the same image gives the same bytes on every day and for any number of threads.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

#include "core/base/job.h"
#include "core/image/volume.h"

namespace hepatica {

// NIfTI-1 (.nii, or .nii.gz compressed), RAS on disk as the format requires, millimetres. Throws
// InputError, naming the file, if it cannot be written, its name has another ending or an axis has
// more than 32767 voxels.
void write_nifti(const std::filesystem::path& file, const Volume& volume);
void write_nifti(const std::filesystem::path& file, const FloatVolume& volume);
void write_nifti(const std::filesystem::path& file, const Mask& mask);
void write_nifti(const std::filesystem::path& file, const LabelMap& labels);

struct SegmentDescription {
    std::uint16_t label = 1;
    std::string name;               // the name shown in 3D Slicer
    Vec3 colour{0.85, 0.40, 0.31};  // red, green, blue in [0, 1]
};

// A .seg.nrrd that 3D Slicer opens as a segmentation, gzip-compressed, LPS. The name must end in
// .seg.nrrd, by which 3D Slicer knows it. Throws InputError as above.
void write_segmentation(const std::filesystem::path& file, const LabelMap& labels,
                        std::span<const SegmentDescription> segments);

struct DicomSeriesInfo {
    std::string patient_name = "Hepatica^Phantom";  // DICOM order: family^given
    std::string patient_id = "HEPATICA";
    std::string series_description = "Synthetic contrast CT";
    std::string study_date = "20000101";  // YYYYMMDD
    double window_centre_hu = 110.0;
    double window_width_hu = 300.0;
};

// A CT series (SOP class CT Image Storage, explicit little endian, 16 bits signed, one file per
// slice, slice_0001.dcm ...) with UIDs derived from the content. Replaces existing slices of such
// names. Begins one stage. Throws InputError as above, or for more than 65535 pixels along a row or
// column; Cancelled.
void write_dicom_series(const std::filesystem::path& folder, const Volume& volume,
                        const DicomSeriesInfo& info, Job& job);

// Whether the file has the name of such a slice.
bool is_written_slice(const std::filesystem::path& file);

}  // namespace hepatica
