// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/crossings.h"

#include <algorithm>

#include "core/deform/potentials/self_contact.h"
#include "core/mesh/crossing_triangles.h"

namespace hepatica {

namespace {

using Corners = std::array<int, 3>;

// Whether a vertex of one and a vertex of the other were one and have not come apart.
bool lie_on_each_other(const DeformPart& deform, const Corners& one, const Corners& other) {
    const TornTopology* torn = deform.torn();
    if (torn == nullptr) return false;
    const auto origin = [&](int v) {
        while (torn->parents()[v] != v) v = torn->parents()[v];
        return v;
    };
    const auto positions = deform.positions_mm();
    return std::ranges::any_of(one, [&](int v) {
        return std::ranges::any_of(other, [&](int w) {
            return v != w && origin(v) == origin(w) &&
                   (positions[v] - positions[w]).norm() < deform.critical_opening_mm();
        });
    });
}

}  // namespace

int crossing_pairs(const DeformPart& deform) {
    const auto triangles = boundary_triangles(deform.shape());
    const auto pairs = crossing_triangles(triangles, deform.positions_mm());
    const SurfaceFeatures features(SurfacePatches(triangles), deform.rest_positions_mm());
    Overlaps overlaps(features);
    if (const auto self = deform.checkpoint().stepper.self) set_pairs(self->overlaps, overlaps);
    return static_cast<int>(std::ranges::count_if(pairs, [&](const auto& pair) {
        return !overlaps.left_out(features.patch_of(pair[0]), features.patch_of(pair[1])) &&
               !lie_on_each_other(deform, triangles[pair[0]], triangles[pair[1]]);
    }));
}

}  // namespace hepatica
