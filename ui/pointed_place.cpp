// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pointed_place.h"

#include <cmath>

namespace hepatica {
namespace {

// A wall so near to a mark is that of its own vessel, and is where one points.
constexpr double farthest_wall_mm = 10.0;

}  // namespace

std::optional<Vec3> pointed_place(const SceneView& view, const Pixel& at, const SurfacePick& pick,
                                  double spheres_beside) {
    const bool on_vessel = pick.triangle >= 0;
    const std::optional<Vec3> mark = view.mark_at(at, on_vessel ? 1.0 : spheres_beside);
    const auto is_of_mark = [&] {
        const double away_mm = (pick.position_mm - *mark).dot(view.axes().forward);
        return std::abs(away_mm) <= farthest_wall_mm;
    };
    if (mark && !(on_vessel && is_of_mark())) return view.point_at_depth(at, *mark);
    return on_vessel ? std::optional(pick.position_mm) : std::nullopt;
}

bool is_behind_vessels(const SceneView& view, const Vec3& place_mm) {
    const SurfacePick pick = view.pick(view.pixel_of(place_mm));
    return pick.triangle >= 0 &&
           (place_mm - pick.position_mm).dot(view.axes().forward) > farthest_wall_mm;
}

}  // namespace hepatica
