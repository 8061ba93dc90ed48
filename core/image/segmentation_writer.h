// SPDX-License-Identifier: GPL-3.0-or-later
// Writes label maps as a DICOM segmentation (DICOM PS3.3 A.51) of their CT series, which archives
// and other viewers can overlay. A helper program, hepatica-dicom-segmentation
// (app/dicom_segmentation), writes the file as a child process with limits, because it reads the
// CT's headers with DCMTK.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <span>
#include <string>

#include "core/base/job.h"
#include "core/image/volume.h"

namespace hepatica {

// A concept of SNOMED CT: code and name.
struct SnomedConcept {
    std::string code;
    std::string meaning;
};

struct SegmentMeaning {
    std::string label;                 // the name shown in viewers
    SnomedConcept category;            // of DICOM's context group 7150
    SnomedConcept type;                // the structure
    std::array<std::uint8_t, 3> srgb;  // recommended colour
};

// Labels and the indices of their segments. The voxels may lie on any grid: a pixel of the CT takes
// the value of the voxel that contains its centre. They must outlive the call.
struct SegmentLayer {
    const Mask* voxels = nullptr;
    std::map<std::uint8_t, std::size_t> segment_of;  // label to index
};

// Throws InputError if the file exists and is not a DICOM segmentation, so that a slice of the CT
// cannot be overwritten by mistake.
void require_segmentation_place(const std::filesystem::path& file);

// Segments of several layers may overlap; a segment without a pixel in the CT is left out. `ct` and
// `series` are as for read_volume(). The file contains patient, study and frame of reference of the
// CT, including the patient's name. Begins one stage. Throws Cancelled; InputError where the CT is
// not a DICOM series of classic slices or lacks identifiers, no segment has a pixel in it, the
// helper is missing or exceeds 2 GiB or two minutes, or the file cannot be written, and as
// require_segmentation_place() does. On an error no file is written.
void write_dicom_segmentation(const std::filesystem::path& file,
                              std::span<const SegmentMeaning> segments,
                              std::span<const SegmentLayer> layers, const std::filesystem::path& ct,
                              int series, const std::string& program_version, Job& job);

}  // namespace hepatica
