// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/step/thinned_skeleton.h"

namespace hepatica::gpu {
namespace {

// Number of vertices of which each node moves the larger share.
std::vector<int> vertices_of(const CoarseSkeleton& skeleton,
                             std::span<const Vec3> rest_positions_mm) {
    const SkeletonBinding binding = bind_vertices(skeleton, rest_positions_mm);
    std::vector<int> vertices(static_cast<std::size_t>(skeleton.size()), 0);
    for (std::size_t v = 0; v < binding.nodes.size(); ++v)
        ++vertices[binding.nodes[v][binding.weights[v][0] >= binding.weights[v][1] ? 0 : 1]];
    return vertices;
}

}  // namespace

CoarseSkeleton thinned(const CoarseSkeleton& skeleton, std::span<const Vec3> rest_positions_mm,
                       int least_vertices) {
    if (skeleton.size() == 0) return {};
    const std::vector<int> vertices = vertices_of(skeleton, rest_positions_mm);
    CoarseSkeleton kept;
    // For each node: the kept node at or nearest above it, and the vertices gathered since then.
    std::vector<int> kept_as, since;
    for (int n = 0; n < skeleton.size(); ++n) {
        const int parent = skeleton.parent[n];
        const int above = parent < 0 ? -1 : kept_as[parent];
        const int gathered = vertices[n] + (parent < 0 ? 0 : since[parent]);
        const bool keeps = parent < 0 || gathered >= least_vertices;
        if (keeps) {
            kept.positions_mm.push_back(skeleton.positions_mm[n]);
            kept.radii_mm.push_back(skeleton.radii_mm[n]);
            kept.parent.push_back(above);
        }
        kept_as.push_back(keeps ? kept.size() - 1 : above);
        since.push_back(keeps ? 0 : gathered);
    }
    return kept;
}

}  // namespace hepatica::gpu
