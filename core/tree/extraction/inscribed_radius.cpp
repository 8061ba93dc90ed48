// SPDX-License-Identifier: GPL-3.0-or-later
// Checks voxels around the query in the order of their distance.
#include "core/tree/extraction/inscribed_radius.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace hepatica {

InscribedRadius::InscribedRadius(const Mask& mask)
    : mask_(mask), reach_mm_(mask.grid.spacing_mm.maxCoeff()) {
    look_further();
}

double InscribedRadius::at(const Index3& voxel) {
    const double finest_mm = mask_.grid.spacing_mm.minCoeff();
    Vec3 move;
    for (int a = 0; a < 3; ++a) move[a] = voxel[a] - last_voxel_[a];
    // The background is no nearer than it was from the last voxel, less the distance from there.
    const double least_mm =
        last_distance_mm_ - move.cwiseProduct(mask_.grid.spacing_mm).norm() - 1e-9;
    while (least_mm > reach_mm_) look_further();
    const auto first = std::ranges::lower_bound(offsets_, least_mm, {}, &Offset::distance_mm);
    for (auto i = static_cast<std::size_t>(first - offsets_.begin());; ++i) {
        if (i == offsets_.size()) look_further();  // earlier entries keep their places
        const Offset& o = offsets_[i];
        const int x = voxel[0] + o.x, y = voxel[1] + o.y, z = voxel[2] + o.z;
        if (mask_.grid.contains(x, y, z) && mask_.at(x, y, z) != 0) continue;
        last_voxel_ = voxel;
        last_distance_mm_ = o.distance_mm;
        return std::max(o.distance_mm - 0.5 * finest_mm, 0.25 * finest_mm);
    }
}

void InscribedRadius::look_further() {
    reach_mm_ *= 1.6;
    offsets_.clear();
    Index3 n{};
    for (int a = 0; a < 3; ++a) n[a] = static_cast<int>(reach_mm_ / mask_.grid.spacing_mm[a]);
    for (int z = -n[2]; z <= n[2]; ++z)
        for (int y = -n[1]; y <= n[1]; ++y)
            for (int x = -n[0]; x <= n[0]; ++x) {
                const double d = Vec3(x, y, z).cwiseProduct(mask_.grid.spacing_mm).norm();
                if (d <= reach_mm_) offsets_.push_back({d, x, y, z});
            }
    std::ranges::sort(offsets_, {}, [](const Offset& offset) {
        return std::tuple(offset.distance_mm, offset.z, offset.y, offset.x);
    });
}

}  // namespace hepatica
