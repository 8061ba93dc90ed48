// SPDX-License-Identifier: GPL-3.0-or-later
// Which series of a DICOM folder is read. An abdominal examination holds several: soft-tissue and
// lung kernels, phases of the contrast, reformats, thick and thin slices. The one that shows the
// liver's vessels best is read, the choice and its reason are named, and the others are offered.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/job.h"
#include "core/image/dicom_slices.h"
#include "core/image/volume_reader.h"

namespace hepatica {

// What the user asks for; the number counts more than the member.
struct SeriesWish {
    std::filesystem::path member;  // a file of the series; may be empty
    int number = 0;                // in the list of list_series, from 1; 0: the best
};

// The series of a folder, CT first and the best first, scouts left out.
std::vector<SeriesDescription> describe_series(const std::vector<DicomSlice>& slices);

// The slices of the series that the wish names, in no order. Where there was a choice, `remarks`
// say which series was preferred to which, and why. Throws InputError where there is no CT or no
// such number.
std::vector<DicomSlice> choose_series(std::vector<DicomSlice> slices, const SeriesWish& wish,
                                      const std::filesystem::path& folder, ReadRemarks& remarks);

}  // namespace hepatica
