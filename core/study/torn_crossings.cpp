// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/torn_crossings.h"

#include <limits>
#include <vector>

#include "core/deform/body/torn_body.h"
#include "core/scene/crossings.h"

namespace hepatica {

int torn_crossings(const TornTopology& torn, const BodyDescription& whole,
                   std::span<const Vec3> now_mm, const OverlapsKept& kept) {
    constexpr double wherever_they_are = std::numeric_limits<double>::infinity();
    std::vector<Vec3> rest_mm = whole.mesh.vertices_mm;
    inherit(torn.parents(), rest_mm);
    return crossing_pairs(torn, wherever_they_are, rest_mm, now_mm, kept);
}

}  // namespace hepatica
