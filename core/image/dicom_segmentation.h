// SPDX-License-Identifier: GPL-3.0-or-later
// Reads a DICOM segmentation (DICOM PS3.3 A.51), which has a frame for each segment and slice.
// Slices without any pixel of a segment are often left out, and segments may overlap.
#pragma once

#include <filesystem>
#include <functional>

#include "core/base/job.h"
#include "core/image/volume.h"

namespace hepatica {

// Decided by the SOP class in the header.
bool is_dicom_segmentation(const std::filesystem::path& file);

// The labels are the numbers of the segments for which wanted() holds; where two overlap, the
// higher one is taken. The grid reaches from the first to the last slice in the file and is that of
// the CT it was drawn on, or a part of it. Throws Cancelled; InputError that names the file where
// it cannot be split into frames (see SplitFrames), or its frames differ in size or orientation,
// are not evenly spaced, or are sheared (tilted gantry).
LabelMap read_dicom_segmentation(const std::filesystem::path& file,
                                 const std::function<bool(int label)>& wanted, Job& job);

}  // namespace hepatica
