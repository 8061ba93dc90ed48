// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/torn_crossings.h"

#include <algorithm>
#include <vector>

#include "core/deform/body/torn_body.h"
#include "core/scene/crossings.h"

namespace hepatica {

int torn_crossings(const TornTopology& torn, const BodyDescription& whole,
                   std::span<const Vec3> now_mm, const OverlapsKept& kept) {
    const auto lie_on_each_other = [&](int v, int w) {
        for (std::size_t i = 0; i + 1 < kept.lying.size(); i += 2)
            if (kept.lying[i] == std::min(v, w) && kept.lying[i + 1] == std::max(v, w)) return true;
        return false;
    };
    std::vector<Vec3> rest_mm = whole.mesh.vertices_mm;
    inherit(torn.parents(), rest_mm);
    return crossing_pairs(torn, lie_on_each_other, rest_mm, now_mm, kept);
}

}  // namespace hepatica
