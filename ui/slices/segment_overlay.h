// SPDX-License-Identifier: GPL-3.0-or-later
// Overlay of Couinaud segments and tumours on a slice, in the colours of the 3D view. It is thin
// enough to read the CT through it and has a stronger border; segments also have their number.
#pragma once

#include <QImage>
#include <QPoint>
#include <cstdint>
#include <vector>

#include "render/palette.h"

namespace hepatica {

// Of a segment's interior and of its border pixels, which separate neighbours of similar lightness.
inline constexpr double segment_opacity = 0.25;
inline constexpr double segment_border_opacity = 0.6;
inline constexpr double tumour_opacity = 0.4, tumour_border_opacity = 0.85;

// A pixel under a tint of this opacity, 0 to 1.
QRgb tinted(QRgb below, const Colour& tint, double opacity);

// Tints the picture where a label is 1 to 8. One label per pixel, row by row.
void lay_segments(QImage& picture, const std::vector<std::uint8_t>& labels);

// Tints the picture in the tumours' colour where a number is not 0.
void lay_tumours(QImage& picture, const std::vector<std::uint8_t>& numbers);

// Colour of a segment's number, which has a dark outline: the segment's own, lightened.
Colour colour_of_number(int segment);

struct SegmentNumber {
    int segment = 0;
    QPoint pixel;    // in the segment
    int pixels = 0;  // of the segment in this slice
};

// Places of the segments' numbers, in ascending order: the pixel of each segment nearest to its
// centroid. Segments of fewer than `least` pixels get none.
std::vector<SegmentNumber> segment_numbers(const std::vector<std::uint8_t>& labels, int columns,
                                           int least);

}  // namespace hepatica
