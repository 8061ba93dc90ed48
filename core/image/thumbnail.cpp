// SPDX-License-Identifier: GPL-3.0-or-later
// Averages of the windowed grey values under each pixel.
#include "core/image/thumbnail.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "core/base/error.h"
#include "core/image/dicom_frames.h"
#include "core/image/dicom_reader.h"

namespace hepatica {

namespace {

// Black is 0, white 255.
double grey_of(double hu, const GreyWindow& window) {
    if (std::isnan(hu)) return 0.0;
    const double black = window.level_hu - 0.5 * window.width_hu;
    return std::clamp(255.0 * (hu - black) / window.width_hu, 0.0, 255.0);
}

// The rows or columns under pixel `i` of `pixels`, at least one.
std::pair<int, int> under(int i, int pixels, int count) {
    const auto edge = [&](int k) {
        return static_cast<int>(static_cast<std::int64_t>(k) * count / pixels);
    };
    const int begin = std::min(edge(i), count - 1);
    return {begin, std::max(begin + 1, edge(i + 1))};
}

bool is_length(double mm) {
    return std::isfinite(mm) && mm > 0.0;
}

}  // namespace

Thumbnail thumbnail_of(const SlicePixels& slice, const GreyWindow& window, int side) {
    const double wide_mm = slice.columns * slice.column_mm, high_mm = slice.rows * slice.row_mm;
    const double scale = side / std::max(wide_mm, high_mm);
    const auto points = [&](double mm) { return std::max(1, static_cast<int>(std::lround(mm))); };
    Thumbnail picture{points(scale * wide_mm), points(scale * high_mm), {}};
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            const auto [top, bottom] = under(y, picture.height, slice.rows);
            const auto [left, right] = under(x, picture.width, slice.columns);
            double sum = 0.0;
            for (int row = top; row < bottom; ++row)
                for (int column = left; column < right; ++column)
                    sum += grey_of(slice.hu[static_cast<std::size_t>(row) * slice.columns + column],
                                   window);
            const double mean = sum / ((bottom - top) * static_cast<double>(right - left));
            picture.grey.push_back(static_cast<std::uint8_t>(std::lround(mean)));
        }
    return picture;
}

Thumbnail thumbnail_of(const std::filesystem::path& dicom_file, int side, Job& job) {
    const std::optional<DicomSlice> slice = read_dicom_slice(dicom_file);
    if (!slice)
        throw InputError("holds no DICOM image", dicom_file.string(), "Choose another series");
    SplitFrames split;  // keeps the frames until they are read
    const std::vector<DicomSlice> frames = split.split({*slice}, job);
    const DicomSlice& middle = frames[frames.size() / 2];
    const std::vector<double> hu = slice_hu(middle);
    SlicePixels pixels{hu, middle.columns, middle.rows};
    if (middle.has_geometry && is_length(middle.column_spacing_mm) &&
        is_length(middle.row_spacing_mm)) {
        pixels.column_mm = middle.column_spacing_mm;
        pixels.row_mm = middle.row_spacing_mm;
    }
    return thumbnail_of(pixels, soft_tissue, side);
}

}  // namespace hepatica
