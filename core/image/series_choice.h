// SPDX-License-Identifier: GPL-3.0-or-later
// Chooses the series of a DICOM folder to read. An abdominal examination holds several: soft-tissue
// and lung kernels, phases of the contrast, reformats, thick and thin slices. The one that shows
// the liver's vessels best is chosen, the reason is stated, and the others are listed.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/job.h"
#include "core/image/dicom_slices.h"
#include "core/image/volume_reader.h"

namespace hepatica {

// The user's choice; a number takes precedence over the member.
struct SeriesWish {
    std::filesystem::path member;  // a file of the series; may be empty
    int number = 0;                // in the list of list_series(), from 1; 0: the best
};

// The series of a folder, CT first and best first, without scout images.
std::vector<SeriesDescription> describe_series(const std::vector<DicomSlice>& slices);

// The slices of the chosen series, unordered. If there was a choice, `remarks` state which series
// was preferred and why. Throws InputError if there is no CT or no series of that number.
std::vector<DicomSlice> choose_series(std::vector<DicomSlice> slices, const SeriesWish& wish,
                                      const std::filesystem::path& folder, ReadRemarks& remarks);

}  // namespace hepatica
