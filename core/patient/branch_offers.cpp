// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/patient/branch_offers.h"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <utility>

#include "core/tree/editing/drawn_vessel.h"
#include "core/tree/station.h"

namespace hepatica {

namespace {

constexpr std::size_t looks = 8;  // places along a branch where it is compared with the tree

// Negative in a lumen.
double beyond_wall_mm(const VesselTree& tree, const Vec3& place_mm) {
    const TreePoint at = nearest_point(tree, place_mm);
    const VesselSegment& segment = tree.segments[static_cast<std::size_t>(at.segment)];
    return at.distance_mm - station_at(segment, at.arclength_mm).radius_mm;
}

// Whether the branch begins on the other one.
bool hangs_on(const Bridge& branch, const Bridge& other) {
    return std::ranges::any_of(other.path_mm, [&](const Vec3& point) {
        return (point - branch.path_mm.front()).norm() <= drawn_touch_mm;
    });
}

}  // namespace

bool leads_out_of(const VesselTree& tree, const Bridge& branch) {
    if (tree.segments.empty() || beyond_wall_mm(tree, branch.path_mm.front()) > drawn_touch_mm ||
        beyond_wall_mm(tree, branch.path_mm.back()) <= drawn_touch_mm)
        return false;
    const std::size_t count = branch.path_mm.size();
    const std::size_t step = std::max<std::size_t>(1, count / looks);
    std::size_t seen = 0, inside = 0;
    for (std::size_t i = 0; i < count; i += step, ++seen)
        inside += beyond_wall_mm(tree, branch.path_mm[i]) < 0.0 ? 1 : 0;
    return 2 * inside < seen;
}

void offer_branches(const std::vector<Bridge>& branches, PatientCase& patient) {
    std::vector<Bridge> waiting = branches, offered;
    const auto fits = [&](const Bridge& branch) {
        const auto carries = [&](const Bridge& other) { return hangs_on(branch, other); };
        return leads_out_of(patient.tree, branch) || std::ranges::any_of(offered, carries);
    };
    for (bool more = true; more;) {
        std::vector<Bridge> left;
        for (const Bridge& branch : waiting) (fits(branch) ? offered : left).push_back(branch);
        more = left.size() < waiting.size();
        waiting = std::move(left);
    }
    std::ranges::stable_sort(offered, std::ranges::greater{}, &Bridge::confidence);
    std::vector<Bridge>& all = patient.corrections.bridges;
    all.insert(all.end(), offered.begin(), offered.end());
}

}  // namespace hepatica
