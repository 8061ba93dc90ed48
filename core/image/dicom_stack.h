// SPDX-License-Identifier: GPL-3.0-or-later
// A tilted gantry gives a sheared stack: each slice is shifted in its plane against the one before.
// The stack is straightened by shifting every slice within its own plane, so that nothing is
// interpolated between slices.
#pragma once

#include <array>
#include <vector>

#include "core/image/dicom_series.h"

namespace hepatica {

// Interpolation between pixels: linear for images, nearest for masks.
enum class BetweenPixels { linear, nearest };

class UprightStack {
  public:
    // The series must outlive this object. If the series is not tilted, nothing is moved.
    UprightStack(const OrderedSeries& series, BetweenPixels between);

    int columns() const { return size_[0]; }  // of a slice large enough for every shifted one
    int rows() const { return size_[1]; }
    Vec3 origin_mm() const;  // centre of its first pixel, in the first slice

    // The values of slice z, row by row, at their position in such a slice. NaN where nothing was
    // scanned, and where a value with positive weight is NaN. Thread-safe.
    std::vector<double> moved(std::size_t z, std::vector<double> values) const;

  private:
    using Pixels = std::array<double, 2>;  // along a row, down a column

    Pixels offset_of(std::size_t z) const;

    const OrderedSeries& series_;
    BetweenPixels between_;
    std::array<int, 2> first_{0, 0};  // first pixel of the stack, in pixels of the first slice
    std::array<int, 2> size_{0, 0};
};

}  // namespace hepatica
