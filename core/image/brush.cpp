// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image/brush.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace hepatica {
namespace {

double distance_to_piece(const Vec3& place, const Vec3& from, const Vec3& to) {
    const Vec3 along = to - from;
    const double squared = along.squaredNorm();
    const double share =
        squared > 0.0 ? std::clamp((place - from).dot(along) / squared, 0.0, 1.0) : 0.0;
    return (place - from - share * along).norm();
}

class Brush {
  public:
    Brush(const BrushStroke& stroke, std::uint8_t label, Mask& mask)
        : stroke_(stroke), label_(label), mask_(mask) {}

    void along_piece(const Vec3& from, const Vec3& to) {
        const Grid& grid = mask_.grid;
        const Vec3 reach = Vec3::Constant(stroke_.radius_mm).cwiseQuotient(grid.spacing_mm);
        const Vec3 a = grid.to_index(from), b = grid.to_index(to);
        std::array<int, 3> first{}, last{};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const auto i = static_cast<Eigen::Index>(axis);
            const double beyond = static_cast<double>(grid.dims[axis]);
            const double low = std::min(a[i], b[i]) - reach[i];
            const double high = std::max(a[i], b[i]) + reach[i];
            first[axis] = static_cast<int>(std::clamp(std::ceil(low), 0.0, beyond));
            last[axis] = static_cast<int>(std::clamp(std::floor(high), -1.0, beyond - 1.0));
        }
        for (int z = first[2]; z <= last[2]; ++z)
            for (int y = first[1]; y <= last[1]; ++y)
                for (int x = first[0]; x <= last[0]; ++x)
                    if (distance_to_piece(grid.to_mm(x, y, z), from, to) <= stroke_.radius_mm)
                        touch(x, y, z);
    }

    void at_centre(const Vec3& place) {
        if (const std::optional<Index3> voxel = voxel_at(mask_.grid, place))
            touch((*voxel)[0], (*voxel)[1], (*voxel)[2]);
    }

  private:
    void touch(int x, int y, int z) {
        std::uint8_t& voxel = mask_.at(x, y, z);
        if (stroke_.erases)
            voxel = 0;
        else if (voxel == 0)
            voxel = label_;
    }

    const BrushStroke& stroke_;
    std::uint8_t label_;
    Mask& mask_;
};

}  // namespace

void apply(const BrushStroke& stroke, std::uint8_t label, Mask& mask) {
    Brush brush(stroke, label, mask);
    for (std::size_t i = 0; i < stroke.path_mm.size(); ++i) {
        brush.at_centre(stroke.path_mm[i]);
        brush.along_piece(stroke.path_mm[i == 0 ? 0 : i - 1], stroke.path_mm[i]);
    }
}

}  // namespace hepatica
