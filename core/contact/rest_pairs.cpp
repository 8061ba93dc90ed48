// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/rest_pairs.h"

#include <algorithm>

namespace hepatica {
namespace {

bool nearer_than(double gap_mm, const SurfacePatches& patches, const std::array<int, 2>& pair,
                 std::span<const Vec3> positions_mm) {
    const double squared = gap_mm * gap_mm;
    for (const int a : patches.triangles_of(pair[0])) {
        const Triangle first = corners_of(patches.triangles()[a], positions_mm);
        for (const int b : patches.triangles_of(pair[1])) {
            const Triangle second = corners_of(patches.triangles()[b], positions_mm);
            if (squared_distance_mm2(first, second) <= squared) return true;
        }
    }
    return false;
}

}  // namespace

RestPairs::RestPairs(const SurfacePatches& patches, std::span<const Vec3> rest_positions_mm,
                     std::span<const std::array<int, 2>> candidates, double gap_mm) {
    for (const auto& pair : candidates)
        if (nearer_than(gap_mm, patches, pair, rest_positions_mm)) pairs_.push_back(pair);
    std::ranges::sort(pairs_);
}

bool RestPairs::left_out(int patch, int other) const {
    const std::array<int, 2> pair{std::min(patch, other), std::max(patch, other)};
    return patch == other || std::ranges::binary_search(pairs_, pair);
}

}  // namespace hepatica
