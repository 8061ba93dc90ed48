// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/body/torn_body.h"

namespace hepatica {

TornBody torn_body_of(const Tearing& tearing) {
    const TornTopology& topology = tearing.topology();
    return {.parents = {topology.parents().begin(), topology.parents().end()},
            .tetrahedra = {topology.tetrahedra().begin(), topology.tetrahedra().end()},
            .parted_pairs = tearing.parted_pairs(),
            .law = tearing.law().softening(),
            .ties = tearing.ties()};
}

BodyDescription torn(const BodyDescription& whole, const TornBody& tear) {
    BodyDescription body = whole;
    inherit(tear.parents, body.mesh.vertices_mm);
    body.mesh.tetrahedra = tear.tetrahedra;
    if (!body.fixed.empty()) inherit(tear.parents, body.fixed);
    return body;
}

std::vector<int> nodes_before(std::span<const int> parents, int count) {
    std::vector<int> before;
    for (std::size_t v = 0; v < parents.size(); ++v)
        before.push_back(static_cast<int>(v) < count ? static_cast<int>(v) : before[parents[v]]);
    return before;
}

}  // namespace hepatica
