// SPDX-License-Identifier: GPL-3.0-or-later
// A small picture of one slice, by which a person tells the series of an examination apart: as long
// and as wide as the slice is in millimetres, in the greys of a soft-tissue window.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

#include "core/base/job.h"
#include "core/image/slice.h"

namespace hepatica {

// One byte a pixel, row by row from the top.
struct Thumbnail {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> grey;
};

// Where radiologists look at the abdomen.
inline constexpr GreyWindow soft_tissue{40.0, 400.0};

// What a slice holds, row by row from the top; values that are not numbers are black.
struct SlicePixels {
    std::span<const double> hu;
    int columns = 0;
    int rows = 0;
    double column_mm = 1.0;  // from one column to the next
    double row_mm = 1.0;
};

// Its longer side has `side` pixels, each the mean of what lies under it.
Thumbnail thumbnail_of(const SlicePixels& slice, const GreyWindow& window, int side);

// Of a DICOM file, as its pixels are stored; they count as square where it does not say how large
// they are. Throws InputError where it cannot be decoded, and Cancelled.
Thumbnail thumbnail_of(const std::filesystem::path& dicom_file, int side, Job& job);

}  // namespace hepatica
