// SPDX-License-Identifier: GPL-3.0-or-later
// A DICOM segmentation (DICOM PS3.3 A.51): where segments are, a frame for each segment and slice.
// Slices without anything of a segment are often left out, and segments may overlap.
#pragma once

#include <filesystem>
#include <functional>

#include "core/base/job.h"
#include "core/image/volume.h"

namespace hepatica {

bool is_dicom_segmentation(const std::filesystem::path& file);

// Labels are the numbers of the segments that are wanted; where two of them overlap, the higher one
// stands. The grid reaches from the first to the last slice that the file holds, and is that of the
// CT it was drawn on, or a part of it. Throws Cancelled; InputError that names the file, where it
// cannot be split into frames (see SplitFrames), its frames are not of one size and orientation,
// not in even steps or aslant (a tilted gantry).
LabelMap read_dicom_segmentation(const std::filesystem::path& file,
                                 const std::function<bool(int label)>& wanted, Job& job);

}  // namespace hepatica
