// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/crossings.h"

#include <algorithm>

#include "core/deform/potentials/surface_pairs.h"
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

int crossing_pairs_of_vessels(const DeformPart& deform, const OverlapsKept& kept) {
    const auto triangles = boundary_triangles(deform.shape());
    const auto pairs = crossing_triangles(triangles, deform.positions_mm());
    const SurfaceFeatures features(SurfacePatches(triangles), deform.rest_positions_mm());
    Overlaps overlaps(features);
    set_pairs(kept, overlaps);
    return static_cast<int>(std::ranges::count_if(pairs, [&](const auto& pair) {
        return !overlaps.left_out(features.patch_of(pair[0]), features.patch_of(pair[1])) &&
               !lie_on_each_other(deform, triangles[pair[0]], triangles[pair[1]]);
    }));
}

int crossing_pairs_with_obstacles(const DeformPart& deform, const OverlapsKept& kept) {
    const auto of_body = boundary_triangles(deform.shape());
    const WithObstacles now =
        with_obstacles(*deform.body().obstacles, deform.positions_mm(), of_body);
    const SurfaceFeatures features(SurfacePatches(now.triangles), now.positions_mm, now.kinds);
    Overlaps overlaps(features);
    set_pairs(kept, overlaps);
    const auto pairs = crossing_triangles(now.triangles, now.positions_mm);
    return static_cast<int>(std::ranges::count_if(pairs, [&](const auto& pair) {
        const int first = features.patch_of(pair[0]), second = features.patch_of(pair[1]);
        return features.may_meet(first, second) && !overlaps.left_out(first, second);
    }));
}

}  // namespace

int crossing_pairs(const std::vector<Corners>& triangles, std::span<const Vec3> rest_mm,
                   std::span<const Vec3> now_mm, const OverlapsKept& kept) {
    const SurfaceFeatures features(SurfacePatches(triangles), rest_mm);
    Overlaps overlaps(features);
    set_pairs(kept, overlaps);
    const auto pairs = crossing_triangles(triangles, now_mm);
    return static_cast<int>(std::ranges::count_if(pairs, [&](const auto& pair) {
        return !overlaps.left_out(features.patch_of(pair[0]), features.patch_of(pair[1]));
    }));
}

int crossing_pairs(const DeformPart& deform) {
    const StepperCheckpoint now = deform.checkpoint().stepper;
    int sum = 0;
    if (now.self) sum += crossing_pairs_of_vessels(deform, now.self->overlaps);
    if (now.obstacles) sum += crossing_pairs_with_obstacles(deform, now.obstacles->touch.overlaps);
    return sum;
}

}  // namespace hepatica
