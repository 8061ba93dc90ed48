// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/leak_places.h"

#include <cmath>
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

}  // namespace

std::vector<int> leaking_vertices(const VesselTree& tree, const std::vector<ThroughTear>& tears,
                                  const TearView& torn, const std::vector<Vec3>& rest_mm,
                                  const std::vector<std::array<int, 3>>& triangles) {
    std::vector<int> vertices;
    const auto rest_of = [&](int v) {
        return rest_mm[static_cast<std::size_t>((*torn.origins)[v])];
    };
    for (const ThroughTear& tear : tears) {
        const VesselSegment& vessel = tree.segments[static_cast<std::size_t>(tear.at.segment)];
        const Vec3 there = station_at(vessel, tear.at.arclength_mm).position_mm;
        const Vec3 direction = direction_at(vessel, tear.at.arclength_mm);
        const double reach = near_radii * std::sqrt(tear.area_mm2 / std::numbers::pi);
        int found = -1, nearest = -1;
        double least = std::numeric_limits<double>::infinity(), nearest_mm = least;
        for (const std::array<int, 3>& t : triangles) {
            const Vec3 middle = (rest_of(t[0]) + rest_of(t[1]) + rest_of(t[2])) / 3.0;
            const double away_mm = (middle - there).norm();
            for (const int v : t) {
                if ((*torn.rims)[static_cast<std::size_t>(v)] == 0 || away_mm >= nearest_mm)
                    continue;
                nearest_mm = away_mm;
                nearest = v;
            }
            if (away_mm > reach) continue;
            const double towards_root = (middle - there).dot(direction);
            for (const int v : t) {
                if ((*torn.rims)[static_cast<std::size_t>(v)] == 0 || towards_root >= least)
                    continue;
                least = towards_root;
                found = v;
            }
        }
        vertices.push_back(found >= 0 ? found : nearest);
    }
    return vertices;
}

}  // namespace hepatica
