// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/crossings.h"

#include <algorithm>

#include "core/deform/potentials/surface_pairs.h"
#include "core/mesh/crossing_triangles.h"

namespace hepatica {

namespace {

using Corners = std::array<int, 3>;

// Whether a vertex of one and a vertex of the other were the same vertex and are together still.
bool lie_on_each_other(const TornTopology& torn, const StillTogether& together, const Corners& one,
                       const Corners& other) {
    const auto origin = [&](int v) {
        while (torn.parents()[v] != v) v = torn.parents()[v];
        return v;
    };
    return std::ranges::any_of(one, [&](int v) {
        return std::ranges::any_of(
            other, [&](int w) { return v != w && origin(v) == origin(w) && together(v, w); });
    });
}

// Number of pairs of triangles that cross now, without overlaps that are left out and without those
// for which `counts(one, other)` is false.
template <class Counts>
int count_crossings(const std::vector<Corners>& triangles, const SurfaceFeatures& features,
                    std::span<const Vec3> now_mm, const OverlapsKept& kept, const Counts& counts) {
    Overlaps overlaps(features);
    set_pairs(kept, overlaps);
    const auto pairs = crossing_triangles(triangles, now_mm);
    return static_cast<int>(std::ranges::count_if(pairs, [&](const auto& pair) {
        return !overlaps.left_out(features.patch_of(pair[0]), features.patch_of(pair[1])) &&
               counts(pair[0], pair[1]);
    }));
}

int crossing_pairs_of_vessels(const DeformPart& deform, const OverlapsKept& kept) {
    const std::span<const Vec3> rest_mm = deform.rest_positions_mm();
    const std::span<const Vec3> now_mm = deform.positions_mm();
    const auto hardly_open = [&](int v, int w) {
        return (now_mm[v] - now_mm[w]).norm() < deform.critical_opening_mm();
    };
    if (deform.torn() != nullptr)
        return crossing_pairs(*deform.torn(), hardly_open, rest_mm, now_mm, kept);
    return crossing_pairs(boundary_triangles(deform.shape()), rest_mm, now_mm, kept);
}

int crossing_pairs_with_obstacles(const DeformPart& deform, const OverlapsKept& kept) {
    const auto of_body = boundary_triangles(deform.shape());
    const WithObstacles now =
        with_obstacles(*deform.body().obstacles, deform.positions_mm(), of_body);
    const SurfaceFeatures features(SurfacePatches(now.triangles), now.positions_mm, now.kinds);
    return count_crossings(
        now.triangles, features, now.positions_mm, kept, [&](int one, int other) {
            return features.may_meet(features.patch_of(one), features.patch_of(other));
        });
}

}  // namespace

int crossing_pairs(const std::vector<Corners>& triangles, std::span<const Vec3> rest_mm,
                   std::span<const Vec3> now_mm, const OverlapsKept& kept) {
    const SurfaceFeatures features(SurfacePatches(triangles), rest_mm);
    return count_crossings(triangles, features, now_mm, kept, [](int, int) { return true; });
}

int crossing_pairs(const TornTopology& torn, const StillTogether& together,
                   std::span<const Vec3> rest_mm, std::span<const Vec3> now_mm,
                   const OverlapsKept& kept) {
    const std::vector<Corners> triangles = torn.surface();
    const SurfaceFeatures features(SurfacePatches(triangles), rest_mm);
    return count_crossings(triangles, features, now_mm, kept, [&](int one, int other) {
        return !lie_on_each_other(torn, together, triangles[one], triangles[other]);
    });
}

int crossing_pairs(const DeformPart& deform) {
    const StepperCheckpoint now = deform.checkpoint().stepper;
    int sum = 0;
    if (now.self) sum += crossing_pairs_of_vessels(deform, now.self->overlaps);
    if (now.obstacles) sum += crossing_pairs_with_obstacles(deform, now.obstacles->touch.overlaps);
    return sum;
}

}  // namespace hepatica
