// SPDX-License-Identifier: GPL-3.0-or-later
// A small picture of one slice for telling the series of an examination apart: with the slice's
// proportions in millimetres, in the greys of a soft-tissue window.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

#include "core/base/job.h"
#include "core/image/slice.h"

namespace hepatica {

// One byte per pixel, row by row from the top.
struct Thumbnail {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> grey;
};

// The usual window for the abdomen.
inline constexpr GreyWindow soft_tissue{40.0, 400.0};

// The values of a slice, row by row from the top; NaN is black.
struct SlicePixels {
    std::span<const double> hu;
    int columns = 0;
    int rows = 0;
    double column_mm = 1.0;  // from one column to the next
    double row_mm = 1.0;
};

// The longer side has `side` pixels; each pixel is the mean of the values under it.
Thumbnail thumbnail_of(const SlicePixels& slice, const GreyWindow& window, int side);

// Thumbnail of a DICOM file (the middle frame of several), as its pixels are stored; they count as
// square if it does not state their size. Throws InputError where it cannot be decoded; Cancelled.
Thumbnail thumbnail_of(const std::filesystem::path& dicom_file, int side, Job& job);

}  // namespace hepatica
