// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/slices/seed_doubt.h"

#include <cmath>

#include "ui/slices/stroke_place.h"
#include "ui/words.h"

namespace hepatica {
namespace {

constexpr double least_hu = 80.0, most_hu = 500.0;
constexpr double seed_mm = 1.0;  // radius of what a seed stands for

// Of the voxel there and those beside it.
double mean_hu(const Volume& ct, const Vec3& position_mm) {
    double sum = 0.0;
    int count = 0;
    for (int z = -1; z <= 1; ++z)
        for (int y = -1; y <= 1; ++y)
            for (int x = -1; x <= 1; ++x) {
                const Vec3 at = ct.grid.to_mm(ct.grid.to_index(position_mm) + Vec3(x, y, z));
                if (!holds(ct.grid, at)) continue;
                sum += value_at(ct, at);
                ++count;
            }
    return count > 0 ? sum / count : 0.0;
}

}  // namespace

QString doubt_of_seed(const Vec3& position_mm, const Volume& ct, const Mask& organs) {
    const double hu = mean_hu(ct, position_mm);
    if (hu < least_hu || hu > most_hu)
        return Words::tr("Seed at %1 HU: hardly a vessel with contrast. Delete takes it back")
            .arg(std::lround(hu));
    if (lies_far_outside({{position_mm}, seed_mm, false}, organs))
        return Words::tr("Seed far outside the liver. Delete takes it back");
    return {};
}

}  // namespace hepatica
