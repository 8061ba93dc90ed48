// SPDX-License-Identifier: GPL-3.0-or-later
// Why a file cannot be split into frames, and what the user can do: the two lines that the helper
// writes to standard error.
#pragma once

#include <string>

namespace hepatica::dicom_frames {

struct Refusal {
    std::string problem;
    std::string remedy =
        "Export it again as classic CT slices, one file a slice (a segmentation: as NIfTI or NRRD)";
};

}  // namespace hepatica::dicom_frames
