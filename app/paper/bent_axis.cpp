// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/paper/bent_axis.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/session/script.h"

namespace hepatica {
namespace {

constexpr double share_a_point = 0.005;  // spacing of points as a share of the longest path
constexpr double radii_around = 0.6;     // in local radii, along the vessel to both sides
constexpr int smoothings = 12;           // passes of averaging with the neighbours

}  // namespace

BentAxis::BentAxis(const VesselTree& tree, double from_share, double to_share,
                   std::span<const VertexPlace> places) {
    const int points = std::max(1, static_cast<int>((to_share - from_share) / share_a_point));
    for (int i = 0; i <= points; ++i) {
        const Vec3 at =
            point_on_longest_path(tree, from_share + (to_share - from_share) * i / points);
        const TreePoint place = nearest_point(tree, at);
        std::vector<int> around;
        for (std::size_t v = 0; v < places.size(); ++v) {
            const TreePoint& other = places[v].on_tree;
            if (other.segment != place.segment ||
                std::abs(other.arclength_mm - place.arclength_mm) >
                    radii_around * places[v].radius_mm)
                continue;
            around.push_back(static_cast<int>(v));
        }
        if (!around.empty()) around_.push_back(std::move(around));
    }
}

std::vector<Vec3> BentAxis::in(const Frame& frame) const {
    std::vector<Vec3> axis;
    for (const std::vector<int>& around : around_) {
        Vec3 sum = Vec3::Zero();
        for (const int v : around) sum += frame.place_mm(v);
        axis.push_back(sum / static_cast<double>(around.size()));
    }
    for (int pass = 0; pass < smoothings; ++pass) {
        const std::vector<Vec3> rough = axis;
        for (std::size_t i = 1; i + 1 < axis.size(); ++i)
            axis[i] = 0.25 * rough[i - 1] + 0.5 * rough[i] + 0.25 * rough[i + 1];
    }
    return axis;
}

}  // namespace hepatica
