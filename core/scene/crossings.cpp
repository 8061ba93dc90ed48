// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/crossings.h"

#include <algorithm>

#include "core/deform/potentials/self_contact.h"
#include "core/mesh/crossing_triangles.h"

namespace hepatica {

int crossing_pairs(const DeformPart& deform) {
    const auto triangles = boundary_triangles(deform.shape());
    const auto pairs = crossing_triangles(triangles, deform.positions_mm());
    const SurfaceFeatures features(SurfacePatches(triangles), deform.rest_positions_mm());
    Overlaps overlaps(features);
    if (const auto self = deform.checkpoint().stepper.self) set_pairs(self->overlaps, overlaps);
    return static_cast<int>(std::ranges::count_if(pairs, [&](const auto& pair) {
        return !overlaps.left_out(features.patch_of(pair[0]), features.patch_of(pair[1]));
    }));
}

}  // namespace hepatica
