// SPDX-License-Identifier: GPL-3.0-or-later
// Visits the voxels in the bounding box of each straight piece of the path.
#include "core/image/brush.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace hepatica {
namespace {

constexpr double slack_mm = 2e-4;

double distance_to_piece(const Vec3& place, const Vec3& from, const Vec3& to) {
    const Vec3 along = to - from;
    const double squared = along.squaredNorm();
    const double share =
        squared > 0.0 ? std::clamp((place - from).dot(along) / squared, 0.0, 1.0) : 0.0;
    return (place - from - share * along).norm();
}

class Brush {
  public:
    Brush(double radius_mm, const Grid& grid, const std::function<void(std::size_t)>& touch)
        : radius_mm_(radius_mm + slack_mm), grid_(grid), touch_(touch) {}

    void along_piece(const Vec3& from, const Vec3& to) {
        const Vec3 reach = Vec3::Constant(radius_mm_).cwiseQuotient(grid_.spacing_mm);
        const Vec3 a = grid_.to_index(from), b = grid_.to_index(to);
        std::array<int, 3> first{}, last{};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const auto i = static_cast<Eigen::Index>(axis);
            const double beyond = static_cast<double>(grid_.dims[axis]);
            const double low = std::min(a[i], b[i]) - reach[i];
            const double high = std::max(a[i], b[i]) + reach[i];
            first[axis] = static_cast<int>(std::clamp(std::ceil(low), 0.0, beyond));
            last[axis] = static_cast<int>(std::clamp(std::floor(high), -1.0, beyond - 1.0));
        }
        for (int z = first[2]; z <= last[2]; ++z)
            for (int y = first[1]; y <= last[1]; ++y)
                for (int x = first[0]; x <= last[0]; ++x)
                    if (distance_to_piece(grid_.to_mm(x, y, z), from, to) <= radius_mm_)
                        touch_(grid_.offset(x, y, z));
    }

    void at_centre(const Vec3& place) {
        if (const std::optional<Index3> voxel = voxel_at(grid_, place))
            touch_(grid_.offset((*voxel)[0], (*voxel)[1], (*voxel)[2]));
    }

  private:
    double radius_mm_;
    const Grid& grid_;
    const std::function<void(std::size_t)>& touch_;
};

}  // namespace

void sweep(const BrushStroke& stroke, const Grid& grid,
           const std::function<void(std::size_t offset)>& touch) {
    Brush brush(stroke.radius_mm, grid, touch);
    for (std::size_t i = 0; i < stroke.path_mm.size(); ++i) {
        brush.at_centre(stroke.path_mm[i]);
        brush.along_piece(stroke.path_mm[i == 0 ? 0 : i - 1], stroke.path_mm[i]);
    }
}

void apply(const BrushStroke& stroke, std::uint8_t label, Mask& mask) {
    const std::uint8_t left = stroke.erases ? std::uint8_t{0} : label;
    sweep(stroke, mask.grid, [&](std::size_t offset) { mask.voxels[offset] = left; });
}

}  // namespace hepatica
