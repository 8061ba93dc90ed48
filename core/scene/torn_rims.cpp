// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/torn_rims.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

namespace hepatica {
namespace {

void mark_parted_edges(const Tearing& tearing, std::vector<std::uint8_t>& rims) {
    const TornTopology& topology = tearing.topology();
    for (const OpenJoint& open : tearing.open_joints()) {
        const Joint& joint = topology.joints()[static_cast<std::size_t>(open.joint)];
        for (int k = 0; k < 3; ++k) {
            const int next = (k + 1) % 3;
            if (!open.corners[static_cast<std::size_t>(k)] ||
                !open.corners[static_cast<std::size_t>(next)])
                continue;
            for (const int corner : {k, next})
                for (const int v : topology.sides(joint, corner))
                    rims[static_cast<std::size_t>(v)] = 1;
        }
    }
}

}  // namespace

std::vector<std::uint8_t> torn_rims(const Tearing& tearing) {
    std::vector<std::uint8_t> rims(static_cast<std::size_t>(tearing.topology().vertex_count()), 0);
    if (tearing.report().joints_broken == 0) {
        mark_parted_edges(tearing, rims);
        return rims;
    }
    std::vector<std::array<int, 2>> bound = tearing.bound_pairs();
    for (auto& [a, b] : bound)
        if (a > b) std::swap(a, b);
    std::ranges::sort(bound);
    for (const std::array<int, 2>& pair : tearing.parted_pairs()) {
        if (std::ranges::binary_search(bound, pair)) continue;
        for (const int v : pair) rims[static_cast<std::size_t>(v)] = 1;
    }
    return rims;
}

}  // namespace hepatica
