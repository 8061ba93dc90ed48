// SPDX-License-Identifier: GPL-3.0-or-later
// Couinaud's segments and tumours over a slice: each in the colour that its branches, or its
// surface, have in the three-dimensional view, thin enough for the CT to be read through it, with a
// firm border; segments with their number.
#pragma once

#include <QImage>
#include <QPoint>
#include <cstdint>
#include <vector>

#include "render/palette.h"

namespace hepatica {

// Of the inside, and of the pixels along the border, where two segments of one colour's lightness
// would else run together.
inline constexpr double segment_opacity = 0.25;
inline constexpr double segment_border_opacity = 0.6;
inline constexpr double tumour_opacity = 0.4, tumour_border_opacity = 0.85;

// Tints the picture where a label is 1 to 8; one label a pixel, row by row.
void lay_segments(QImage& picture, const std::vector<std::uint8_t>& labels);

// Tints it where a label is not 0, in the colour of tumours.
void lay_tumours(QImage& picture, const std::vector<std::uint8_t>& numbers);

// In which a segment's number is written, in a dark outline: its own, but light.
Colour colour_of_number(int segment);

struct SegmentNumber {
    int segment = 0;
    QPoint pixel;  // well inside
};

// Where the numbers of the segments of a slice are written, in their order: at the pixel of each
// that is nearest to its middle. Pieces of less than `least` pixels get none.
std::vector<SegmentNumber> segment_numbers(const std::vector<std::uint8_t>& labels, int columns,
                                           int least);

}  // namespace hepatica
