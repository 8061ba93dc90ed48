// SPDX-License-Identifier: GPL-3.0-or-later
// Each slice is shifted within its plane by bilinear or nearest interpolation.
#include "core/image/dicom_stack.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hepatica {

namespace {

// Positions are rounded in the file, so smaller fractions of a pixel are no shift.
constexpr double steps_per_pixel = 1024.0;

// Along one axis: a shifted pixel is a mixture of the pixels `whole` and `whole` + 1 before it.
struct Shift {
    int whole = 0;
    double part = 0.0;  // weight of the one farther away, in [0, 1)
};

Shift shift_by(double pixels) {
    const double whole = std::floor(pixels);
    return {static_cast<int>(whole), pixels - whole};
}

}  // namespace

UprightStack::UprightStack(const OrderedSeries& series, BetweenPixels between)
    : series_(series), between_(between) {
    const DicomSlice& first = series.slices.front();
    size_ = {first.columns, first.rows};
    for (int a = 0; a < 2; ++a) {
        double least = 0.0, most = 0.0;
        for (std::size_t z = 0; z < series.slices.size(); ++z) {
            const double offset = offset_of(z)[static_cast<std::size_t>(a)];
            least = std::min(least, offset);
            most = std::max(most, offset);
        }
        first_[a] = static_cast<int>(std::floor(least));
        size_[a] += static_cast<int>(std::ceil(most)) - first_[a];
    }
}

Vec3 UprightStack::origin_mm() const {
    const DicomSlice& first = series_.slices.front();
    return first.position_mm + first.row_axis.normalized() * (first_[0] * first.column_spacing_mm) +
           first.column_axis.normalized() * (first_[1] * first.row_spacing_mm);
}

UprightStack::Pixels UprightStack::offset_of(std::size_t z) const {
    if (series_.tilt_degrees == 0.0) return {0.0, 0.0};
    const DicomSlice& first = series_.slices.front();
    const Vec3 offset_mm = series_.slices[z].position_mm - first.position_mm;
    Pixels offset{offset_mm.dot(first.row_axis.normalized()) / first.column_spacing_mm,
                  offset_mm.dot(first.column_axis.normalized()) / first.row_spacing_mm};
    const double steps = between_ == BetweenPixels::nearest ? 1.0 : steps_per_pixel;
    for (double& pixels : offset) pixels = std::round(pixels * steps) / steps;
    return offset;
}

std::vector<double> UprightStack::moved(std::size_t z, std::vector<double> values) const {
    if (series_.tilt_degrees == 0.0) return values;
    const DicomSlice& first = series_.slices.front();
    const Pixels offset = offset_of(z);
    const Shift right = shift_by(offset[0] - first_[0]), down = shift_by(offset[1] - first_[1]);
    // 0 times NaN is NaN, so pixels of weight 0 are not read.
    const auto value_at = [&](int x, int y, double weight) {
        if (weight == 0.0) return 0.0;
        if (x < 0 || y < 0 || x >= first.columns || y >= first.rows)
            return std::numeric_limits<double>::quiet_NaN();
        return weight * values[static_cast<std::size_t>(y) * first.columns + x];
    };
    std::vector<double> upright;
    upright.reserve(static_cast<std::size_t>(columns()) * rows());
    for (int y = -down.whole; y < rows() - down.whole; ++y)
        for (int x = -right.whole; x < columns() - right.whole; ++x)
            upright.push_back(value_at(x, y, (1.0 - right.part) * (1.0 - down.part)) +
                              value_at(x - 1, y, right.part * (1.0 - down.part)) +
                              value_at(x, y - 1, (1.0 - right.part) * down.part) +
                              value_at(x - 1, y - 1, right.part * down.part));
    return upright;
}

}  // namespace hepatica
