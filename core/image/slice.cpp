// SPDX-License-Identifier: GPL-3.0-or-later
// Maps picture coordinates to the axes of a grid that are nearest to the patient's axes.
#include "core/image/slice.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

namespace hepatica {
namespace {

// The patient's axes (x to the left, y to the back, z to the head) along columns, rows and slices
// of a picture, and whether the picture runs against them.
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

// The grid's axis nearest to each of the patient's: the assignment with the largest sum of cosines.
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

// The pixels of a picture in continuous indices of a grid.
struct PlaneOfPixels {
    Vec3 begin;                      // the first pixel
    Vec3 along_columns, along_rows;  // from one pixel to the next
    int columns, rows;
};

int nearest(double index) {
    return static_cast<int>(std::floor(index + 0.5));
}

// The axes of the grid along which columns and rows run; nothing if one of them is oblique.
std::optional<std::array<int, 2>> axes_of(const PlaneOfPixels& plane) {
    constexpr double most_off = 1e-6;  // in voxels over the whole picture; allows for rounding
    const auto axis_of = [](const Vec3& step, int pixels) {
        int axis = 0;
        step.cwiseAbs().maxCoeff(&axis);
        Vec3 others = step * pixels;
        others[axis] = 0.0;
        return others.norm() < most_off ? axis : -1;
    };
    const int across = axis_of(plane.along_columns, plane.columns);
    const int down = axis_of(plane.along_rows, plane.rows);
    if (across < 0 || down < 0 || across == down) return std::nullopt;
    return std::array{across, down};
}

constexpr std::ptrdiff_t outside = -1;

// Offsets in memory of evenly spaced indices along an axis of the grid; `outside` for those
// outside.
std::vector<std::ptrdiff_t> offsets_along(const Grid& grid, int axis, double begin, double step,
                                          int count) {
    std::vector<std::ptrdiff_t> offsets;
    const std::ptrdiff_t nx = grid.dims[0], ny = grid.dims[1];
    const std::ptrdiff_t stride = axis == 0 ? 1 : axis == 1 ? nx : nx * ny;
    for (int i = 0; i < count; ++i) {
        const int index = nearest(begin + i * step);
        offsets.push_back(index >= 0 && index < grid.dims[axis] ? index * stride : outside);
    }
    return offsets;
}

std::vector<std::uint8_t> no_labels(const PlaneOfPixels& plane) {
    return std::vector<std::uint8_t>(static_cast<std::size_t>(plane.columns) *
                                     static_cast<std::size_t>(plane.rows));
}

// Offsets are computed once per axis, some eight times as fast as pixel by pixel.
std::vector<std::uint8_t> labels_along_axes(const Mask& labels, const PlaneOfPixels& plane,
                                            const std::array<int, 2>& axes) {
    auto found = no_labels(plane);
    const auto [across, down] = axes;
    const int third = 3 - across - down;
    const std::ptrdiff_t first =
        offsets_along(labels.grid, third, plane.begin[third], 0.0, 1).front();
    if (first == outside) return found;
    const auto right = offsets_along(labels.grid, across, plane.begin[across],
                                     plane.along_columns[across], plane.columns);
    const auto below =
        offsets_along(labels.grid, down, plane.begin[down], plane.along_rows[down], plane.rows);
    std::uint8_t* pixel = found.data();
    for (const std::ptrdiff_t row : below) {
        if (row != outside) {
            const std::uint8_t* const line = labels.voxels.data() + first + row;
            for (std::size_t column = 0; column < right.size(); ++column)
                if (right[column] != outside) pixel[column] = line[right[column]];
        }
        pixel += right.size();
    }
    return found;
}

std::vector<std::uint8_t> labels_across_axes(const Mask& labels, const PlaneOfPixels& plane) {
    auto found = no_labels(plane);
    std::uint8_t* pixel = found.data();
    for (int row = 0; row < plane.rows; ++row)
        for (int column = 0; column < plane.columns; ++column, ++pixel) {
            const Vec3 index = plane.begin + column * plane.along_columns + row * plane.along_rows;
            const int x = nearest(index.x()), y = nearest(index.y()), z = nearest(index.z());
            if (labels.grid.contains(x, y, z)) *pixel = labels.at(x, y, z);
        }
    return found;
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
    const double black = window.level_hu - 0.5 * window.width_hu;
    const double steps = 255.0 / window.width_hu;
    // Columns and rows run along the grid's axes, so the offsets are evenly spaced.
    const auto offset_of = [&](int column, int row) {
        const auto [x, y, z] = stack.voxel(column, row, slice);
        return static_cast<std::ptrdiff_t>(ct.grid.offset(x, y, z));
    };
    const std::ptrdiff_t columns = stack.columns(), first = offset_of(0, 0);
    const std::ptrdiff_t right = columns > 1 ? offset_of(1, 0) - first : 0;
    const std::ptrdiff_t down = stack.rows() > 1 ? offset_of(0, 1) - first : 0;
    std::vector<std::uint8_t> grey(static_cast<std::size_t>(columns * stack.rows()));
    std::uint8_t* pixel = grey.data();
    for (int row = 0; row < stack.rows(); ++row) {
        const auto* voxel = ct.voxels.data() + first + row * down;
        for (std::ptrdiff_t column = 0; column < columns; ++column) {
            const double value = std::clamp((voxel[column * right] - black) * steps, 0.0, 255.0);
            *pixel++ = static_cast<std::uint8_t>(value + 0.5);
        }
    }
    return grey;
}

std::vector<std::uint8_t> label_slice(const Mask& labels, const SliceStack& stack, int slice) {
    const Grid& grid = labels.grid;
    const auto index_at = [&](int column, int row) {
        return grid.to_index(stack.to_mm(Vec3(column, row, slice)));
    };
    const Vec3 begin = index_at(0, 0);
    const PlaneOfPixels plane{begin, index_at(1, 0) - begin, index_at(0, 1) - begin,
                              stack.columns(), stack.rows()};
    const auto axes = axes_of(plane);
    return axes ? labels_along_axes(labels, plane, *axes) : labels_across_axes(labels, plane);
}

}  // namespace hepatica
