// SPDX-License-Identifier: GPL-3.0-or-later
// Slices of a volume in radiological orientation: axial seen from the feet, coronal from the front,
// sagittal from the left, so that the patient's right is at the left of the picture and his front
// at its top or left. Slices run along the axes of the grid nearest to those of the patient;
// nothing is resampled.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/image/volume.h"

namespace hepatica {

enum class SliceDirection { axial, coronal, sagittal };

// The slices of a grid in one direction. Columns run to the right of the picture, rows down. Axial
// slices are counted towards the head, coronal ones towards the back, sagittal ones towards the
// patient's left. Immutable and thread-safe.
class SliceStack {
  public:
    SliceStack(const Grid& grid, SliceDirection direction);

    int columns() const { return grid_.dims[axis_[0]]; }
    int rows() const { return grid_.dims[axis_[1]]; }
    int count() const { return grid_.dims[axis_[2]]; }
    double column_mm() const { return grid_.spacing_mm[axis_[0]]; }
    double row_mm() const { return grid_.spacing_mm[axis_[1]]; }
    double slice_mm() const { return grid_.spacing_mm[axis_[2]]; }

    Index3 voxel(int column, int row, int slice) const;
    // Column, row and slice of a point, integers at the centres of voxels, and back.
    Vec3 place_of(const Vec3& position_mm) const;
    Vec3 to_mm(const Vec3& place) const;

    // The direction of the left, right, upper and lower edge of the picture: R, L, A, P, H or F.
    std::array<char, 4> edges() const;

  private:
    Grid grid_;
    SliceDirection direction_;
    std::array<int, 3> axis_{};        // axes of the grid along columns, rows and slices
    std::array<bool, 3> backwards_{};  // whether that axis runs against columns, rows or slices
};

// The Hounsfield units shown between black and white: a range of `width_hu` > 0 around `level_hu`.
struct GreyWindow {
    double level_hu = 100.0;
    double width_hu = 300.0;
};

// Grey values, one byte per pixel, row by row from the top; `slice` in [0, count). Cost: its
// pixels.
std::vector<std::uint8_t> grey_slice(const Volume& ct, const SliceStack& stack, int slice,
                                     const GreyWindow& window);

// The label of the voxel nearest to the centre of each pixel of a slice of `stack`, 0 outside the
// labels. The grid of `stack` may differ from that of the labels.
std::vector<std::uint8_t> label_slice(const Mask& labels, const SliceStack& stack, int slice);

}  // namespace hepatica
