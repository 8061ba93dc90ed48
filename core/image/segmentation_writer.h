// SPDX-License-Identifier: GPL-3.0-or-later
// Label maps as a DICOM segmentation (DICOM PS3.3 A.51) of the CT series that they belong to, which
// archives and other viewers show over it. Written by a helper, hepatica-dicom-segmentation
// (app/dicom_segmentation), a child process under limits, because it reads the CT's headers by
// DCMTK.
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

// A concept of SNOMED CT: its number and its name.
struct SnomedConcept {
    std::string code;
    std::string meaning;
};

struct SegmentMeaning {
    std::string label;                 // what viewers call it
    SnomedConcept category;            // of DICOM's context group 7150
    SnomedConcept type;                // what it is
    std::array<std::uint8_t, 3> srgb;  // recommended colour
};

// Labels and the segments that they stand for, as indices. The voxels may lie on any grid: a pixel
// of the CT takes the value of the voxel that its centre lies in. They must outlive the call.
struct SegmentLayer {
    const Mask* voxels = nullptr;
    std::map<std::uint8_t, std::size_t> segment_of;  // label to index
};

// Throws InputError where a file is there that is no DICOM segmentation: a slip of the hand
// overwrites no slice of the CT.
void require_segmentation_place(const std::filesystem::path& file);

// Segments of several layers may overlap; one without a pixel in the CT is left out. `ct` and
// `series` are as for read_volume(). The file holds patient, study and frame of reference of the
// CT, the patient's name among them. Begins one stage. Throws Cancelled; InputError where the CT is
// no DICOM series of classic slices, lacks identifiers, no segment has a pixel in it, the helper is
// missing or takes more than 2 GiB or two minutes, or the file cannot be written: nothing is then;
// as require_segmentation_place() does.
void write_dicom_segmentation(const std::filesystem::path& file,
                              std::span<const SegmentMeaning> segments,
                              std::span<const SegmentLayer> layers, const std::filesystem::path& ct,
                              int series, const std::string& program_version, Job& job);

}  // namespace hepatica
