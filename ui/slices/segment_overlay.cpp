// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/slices/segment_overlay.h"

#include <array>
#include <cstddef>
#include <functional>
#include <optional>

namespace hepatica {
namespace {

constexpr int segments = 8;

bool is_segment(int label) {
    return label >= 1 && label <= segments;
}

struct Opacity {
    double inside = 0.0, border = 0.0;
};

// Blends in the colour that `tint` gives to a label; pixels at the border to any other label get
// their own opacity.
void lay_labels(QImage& picture, const std::vector<std::uint8_t>& labels, const Opacity& opacity,
                const std::function<std::optional<Colour>(int label)>& tint) {
    const int columns = picture.width(), rows = picture.height();
    const auto label = [&](int column, int row) {
        const bool inside = column >= 0 && column < columns && row >= 0 && row < rows;
        return inside ? int{labels[static_cast<std::size_t>(row) * columns + column]} : 0;
    };
    for (int row = 0; row < rows; ++row) {
        auto* line = reinterpret_cast<QRgb*>(picture.scanLine(row));
        for (int column = 0; column < columns; ++column) {
            const int here = label(column, row);
            const std::optional<Colour> colour = here == 0 ? std::nullopt : tint(here);
            if (!colour) continue;
            const bool border = label(column - 1, row) != here || label(column + 1, row) != here ||
                                label(column, row - 1) != here || label(column, row + 1) != here;
            line[column] = tinted(line[column], *colour, border ? opacity.border : opacity.inside);
        }
    }
}

}  // namespace

QRgb tinted(QRgb below, const Colour& tint, double opacity) {
    const auto channel = [&](int plain, double colour) {
        return static_cast<int>((1.0 - opacity) * plain + opacity * 255.0 * colour);
    };
    return qRgb(channel(qRed(below), tint[0]), channel(qGreen(below), tint[1]),
                channel(qBlue(below), tint[2]));
}

Colour colour_of_number(int segment) {
    Colour light{};
    const Colour own = palette::liver_segment(segment);
    for (std::size_t c = 0; c < own.size(); ++c) light[c] = 0.35 * own[c] + 0.65;
    return light;
}

void lay_segments(QImage& picture, const std::vector<std::uint8_t>& labels) {
    lay_labels(picture, labels, {segment_opacity, segment_border_opacity}, [](int label) {
        return is_segment(label) ? std::optional(palette::liver_segment(label)) : std::nullopt;
    });
}

void lay_tumours(QImage& picture, const std::vector<std::uint8_t>& numbers) {
    lay_labels(picture, numbers, {tumour_opacity, tumour_border_opacity},
               [](int) { return std::optional(palette::tumour); });
}

std::vector<SegmentNumber> segment_numbers(const std::vector<std::uint8_t>& labels, int columns,
                                           int least) {
    struct Region {
        double column_sum = 0.0, row_sum = 0.0;
        int pixels = 0;
        double nearest = 0.0;  // squared distance of `pixel` from the centroid, in pixels
        QPoint pixel;
    };
    std::array<Region, segments + 1> regions{};
    const auto over_labels = [&](const auto& look) {
        for (std::size_t i = 0; i < labels.size(); ++i)
            if (is_segment(labels[i]))
                look(regions[labels[i]], static_cast<int>(i) % columns,
                     static_cast<int>(i) / columns);
    };
    over_labels([](Region& region, int column, int row) {
        region.column_sum += column;
        region.row_sum += row;
        ++region.pixels;
    });
    for (Region& region : regions) region.nearest = static_cast<double>(labels.size()) * columns;
    over_labels([](Region& region, int column, int row) {
        const double across = column - region.column_sum / region.pixels;
        const double down = row - region.row_sum / region.pixels;
        const double away = across * across + down * down;
        if (away >= region.nearest) return;
        region.nearest = away;
        region.pixel = QPoint(column, row);
    });
    std::vector<SegmentNumber> numbers;
    for (int segment = 1; segment <= segments; ++segment)
        if (const Region& region = regions[static_cast<std::size_t>(segment)];
            region.pixels > 0 && region.pixels >= least)
            numbers.push_back({segment, region.pixel, region.pixels});
    return numbers;
}

}  // namespace hepatica
