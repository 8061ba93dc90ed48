// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/leak_places.h"

#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

#include "core/tree/station.h"

namespace hepatica {
namespace {

// The rims of a tear are searched for within this many radii.
constexpr double near_radii = 2.5;

// Direction of the vessel, away from the root.
Vec3 direction_at(const VesselSegment& vessel, double arclength_mm) {
    constexpr double around_mm = 0.5;
    return station_at(vessel, arclength_mm + around_mm).position_mm -
           station_at(vessel, arclength_mm - around_mm).position_mm;
}

// Few triangles have a corner on a rim; the others are looked at once, not for each tear.
struct AtRim {
    Vec3 middle = Vec3::Zero();    // of the triangle, at rest
    std::array<int, 3> corners{};  // -1: not on a rim
};

std::vector<AtRim> triangles_at_rims(const TearView& torn, const std::vector<Vec3>& rest_mm,
                                     const std::vector<std::array<int, 3>>& triangles) {
    const auto rest_of = [&](int v) -> const Vec3& {
        return rest_mm[static_cast<std::size_t>((*torn.origins)[static_cast<std::size_t>(v)])];
    };
    std::vector<AtRim> found;
    for (const std::array<int, 3>& t : triangles) {
        AtRim at{.corners = {-1, -1, -1}};
        bool any = false;
        for (std::size_t k = 0; k < 3; ++k) {
            if ((*torn.rims)[static_cast<std::size_t>(t[k])] == 0) continue;
            at.corners[k] = t[k];
            any = true;
        }
        if (!any) continue;
        at.middle = (rest_of(t[0]) + rest_of(t[1]) + rest_of(t[2])) / 3.0;
        found.push_back(at);
    }
    return found;
}

}  // namespace

std::vector<int> leaking_vertices(const VesselTree& tree, const std::vector<ThroughTear>& tears,
                                  const TearView& torn, const std::vector<Vec3>& rest_mm,
                                  const std::vector<std::array<int, 3>>& triangles) {
    std::vector<int> vertices;
    const std::vector<AtRim> rims = triangles_at_rims(torn, rest_mm, triangles);
    for (const ThroughTear& tear : tears) {
        const VesselSegment& vessel = tree.segments[static_cast<std::size_t>(tear.at.segment)];
        const Vec3 there = station_at(vessel, tear.at.arclength_mm).position_mm;
        const Vec3 direction = direction_at(vessel, tear.at.arclength_mm);
        const double reach = near_radii * std::sqrt(tear.area_mm2 / std::numbers::pi);
        int found = -1, nearest = -1;
        double least = std::numeric_limits<double>::infinity(), nearest_mm = least;
        for (const AtRim& at : rims) {
            const double away_mm = (at.middle - there).norm();
            const double towards_root = (at.middle - there).dot(direction);
            for (const int v : at.corners) {
                if (v < 0) continue;
                if (away_mm < nearest_mm) {
                    nearest_mm = away_mm;
                    nearest = v;
                }
                if (away_mm > reach || towards_root >= least) continue;
                least = towards_root;
                found = v;
            }
        }
        vertices.push_back(found >= 0 ? found : nearest);
    }
    return vertices;
}

}  // namespace hepatica
