// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image/slice.h"

#include <algorithm>
#include <cmath>

namespace hepatica {
namespace {

// Of the patient's axes (x to the left, y to the back, z to the head): along columns, rows and
// slices of a picture, and whether they run against them.
struct PictureAxes {
    std::array<int, 3> axis;
    std::array<bool, 3> backwards;
};

PictureAxes picture_axes(SliceDirection direction) {
    switch (direction) {
        case SliceDirection::axial:
            return {{0, 1, 2}, {false, false, false}};
        case SliceDirection::coronal:
            return {{0, 2, 1}, {false, true, false}};
        case SliceDirection::sagittal:
            break;
    }
    return {{1, 2, 0}, {false, true, false}};
}

// The grid's axis nearest to each of the patient's: of all ways to pair them the one with the
// largest sum of cosines.
std::array<int, 3> nearest_axes(const Mat3& direction) {
    std::array<int, 3> order{0, 1, 2}, best = order;
    double most = -1.0;
    do {
        double sum = 0.0;
        for (int i = 0; i < 3; ++i)
            sum += std::abs(direction(i, order[static_cast<std::size_t>(i)]));
        if (sum > most) {
            most = sum;
            best = order;
        }
    } while (std::next_permutation(order.begin(), order.end()));
    return best;
}

}  // namespace

SliceStack::SliceStack(const Grid& grid, SliceDirection direction)
    : grid_(grid), direction_(direction) {
    const PictureAxes wanted = picture_axes(direction);
    const std::array<int, 3> nearest = nearest_axes(grid.direction);
    for (std::size_t i = 0; i < 3; ++i) {
        const int of_patient = wanted.axis[i];
        axis_[i] = nearest[static_cast<std::size_t>(of_patient)];
        const bool against_patient = grid.direction(of_patient, axis_[i]) < 0.0;
        backwards_[i] = against_patient != wanted.backwards[i];
    }
}

Index3 SliceStack::voxel(int column, int row, int slice) const {
    const std::array<int, 3> place{column, row, slice};
    Index3 voxel{0, 0, 0};
    for (std::size_t i = 0; i < 3; ++i)
        voxel[axis_[i]] = backwards_[i] ? grid_.dims[axis_[i]] - 1 - place[i] : place[i];
    return voxel;
}

Vec3 SliceStack::place_of(const Vec3& position_mm) const {
    const Vec3 index = grid_.to_index(position_mm);
    Vec3 place;
    for (std::size_t i = 0; i < 3; ++i)
        place[static_cast<int>(i)] =
            backwards_[i] ? grid_.dims[axis_[i]] - 1 - index[axis_[i]] : index[axis_[i]];
    return place;
}

Vec3 SliceStack::to_mm(const Vec3& place) const {
    Vec3 index;
    for (std::size_t i = 0; i < 3; ++i) {
        const double along = place[static_cast<int>(i)];
        index[axis_[i]] = backwards_[i] ? grid_.dims[axis_[i]] - 1 - along : along;
    }
    return grid_.to_mm(index);
}

std::array<char, 4> SliceStack::edges() const {
    constexpr std::array<char, 3> begins{'R', 'A', 'F'}, ends{'L', 'P', 'H'};
    const PictureAxes axes = picture_axes(direction_);
    const auto across = static_cast<std::size_t>(axes.axis[0]);
    const auto down = static_cast<std::size_t>(axes.axis[1]);
    const bool upwards = axes.backwards[1];
    return {begins[across], ends[across], upwards ? ends[down] : begins[down],
            upwards ? begins[down] : ends[down]};
}

std::vector<std::uint8_t> grey_slice(const Volume& ct, const SliceStack& stack, int slice,
                                     const GreyWindow& window) {
    std::vector<std::uint8_t> grey;
    grey.reserve(static_cast<std::size_t>(stack.columns()) *
                 static_cast<std::size_t>(stack.rows()));
    const double black = window.level_hu - 0.5 * window.width_hu;
    const double steps = 255.0 / window.width_hu;
    // A picture's columns and rows run along the grid's axes: even steps through its voxels.
    const auto offset_of = [&](int column, int row) {
        const auto [x, y, z] = stack.voxel(column, row, slice);
        return static_cast<std::ptrdiff_t>(ct.grid.offset(x, y, z));
    };
    const std::ptrdiff_t first = offset_of(0, 0);
    const std::ptrdiff_t right = stack.columns() > 1 ? offset_of(1, 0) - first : 0;
    const std::ptrdiff_t down = stack.rows() > 1 ? offset_of(0, 1) - first : 0;
    for (int row = 0; row < stack.rows(); ++row)
        for (int column = 0; column < stack.columns(); ++column) {
            const auto at = static_cast<std::size_t>(first + row * down + column * right);
            const double value = std::clamp((ct.voxels[at] - black) * steps, 0.0, 255.0);
            grey.push_back(static_cast<std::uint8_t>(value + 0.5));
        }
    return grey;
}

std::vector<std::uint8_t> label_slice(const Mask& labels, const SliceStack& stack, int slice) {
    std::vector<std::uint8_t> found;
    found.reserve(static_cast<std::size_t>(stack.columns()) *
                  static_cast<std::size_t>(stack.rows()));
    const auto index_at = [&](int column, int row) {
        return labels.grid.to_index(stack.to_mm(Vec3(column, row, slice)));
    };
    const Vec3 begin = index_at(0, 0);
    const Vec3 along_columns = index_at(1, 0) - begin, along_rows = index_at(0, 1) - begin;
    for (int row = 0; row < stack.rows(); ++row)
        for (int column = 0; column < stack.columns(); ++column) {
            const Vec3 index = begin + column * along_columns + row * along_rows;
            const int x = static_cast<int>(std::floor(index.x() + 0.5));
            const int y = static_cast<int>(std::floor(index.y() + 0.5));
            const int z = static_cast<int>(std::floor(index.z() + 0.5));
            found.push_back(labels.grid.contains(x, y, z) ? labels.at(x, y, z) : 0);
        }
    return found;
}

}  // namespace hepatica
