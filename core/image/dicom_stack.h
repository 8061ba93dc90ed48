// SPDX-License-Identifier: GPL-3.0-or-later
// A gantry that was tilted leaves a sheared stack: each slice lies farther up or down in its plane
// than the one before. The stack is put upright by moving every slice within its own plane, so that
// nothing is interpolated between slices.
#pragma once

#include <array>
#include <vector>

#include "core/image/dicom_series.h"

namespace hepatica {

// How values between pixels are made: an image's by linear interpolation, a mask's never.
enum class BetweenPixels { linear, nearest };

class UprightStack {
  public:
    // The series must outlive it. Where the series is not tilted, nothing is moved.
    UprightStack(const OrderedSeries& series, BetweenPixels between);

    int columns() const { return size_[0]; }  // of a slice that holds every moved one
    int rows() const { return size_[1]; }
    Vec3 origin_mm() const;  // centre of its first pixel, in the first slice

    // The values of slice z, row by row, in the place that they have in such a slice. NaN where the
    // scan does not reach, and where a value would be made of one that is NaN.
    std::vector<double> moved(std::size_t z, std::vector<double> values) const;

  private:
    using Pixels = std::array<double, 2>;  // along a row, down a column

    Pixels offset_of(std::size_t z) const;

    const OrderedSeries& series_;
    BetweenPixels between_;
    std::array<int, 2> first_{0, 0};  // pixel of the first slice at which the stack begins
    std::array<int, 2> size_{0, 0};
};

}  // namespace hepatica
