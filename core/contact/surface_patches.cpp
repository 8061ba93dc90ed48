// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/surface_patches.h"

#include <algorithm>
#include <map>
#include <utility>

namespace hepatica {
namespace {

// For each triangle, those that share an edge with it.
std::vector<std::vector<int>> neighbours_of(const std::vector<std::array<int, 3>>& triangles) {
    std::map<std::pair<int, int>, std::vector<int>> at_edge;
    for (std::size_t t = 0; t < triangles.size(); ++t)
        for (int a = 0; a < 3; ++a) {
            const int i = triangles[t][a], j = triangles[t][(a + 1) % 3];
            at_edge[std::minmax(i, j)].push_back(static_cast<int>(t));
        }
    std::vector<std::vector<int>> neighbours(triangles.size());
    for (const auto& [edge, sharing] : at_edge)
        for (const int t : sharing)
            for (const int other : sharing)
                if (other != t) neighbours[t].push_back(other);
    return neighbours;
}

}  // namespace

SurfacePatches::SurfacePatches(std::vector<std::array<int, 3>> triangles, int triangles_in_patch)
    : triangles_(std::move(triangles)) {
    const auto neighbours = neighbours_of(triangles_);
    std::vector<char> taken(triangles_.size(), 0);
    for (std::size_t first = 0; first < triangles_.size(); ++first) {
        if (taken[first]) continue;
        std::vector<int> patch{static_cast<int>(first)};
        taken[first] = 1;
        for (std::size_t next = 0; next < patch.size(); ++next)
            for (const int other : neighbours[patch[next]]) {
                if (taken[other] || static_cast<int>(patch.size()) >= triangles_in_patch) continue;
                taken[other] = 1;
                patch.push_back(other);
            }
        std::ranges::sort(patch);
        std::vector<int> vertices;
        for (const int t : patch)
            vertices.insert(vertices.end(), triangles_[t].begin(), triangles_[t].end());
        std::ranges::sort(vertices);
        vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
        triangles_of_.push_back(std::move(patch));
        vertices_of_.push_back(std::move(vertices));
    }
}

// Loads four numbers at a time, which takes half as long as single ones; the fourth belongs to the
// next vertex and is ignored. The last vertex has no next one and is treated apart.
Box SurfacePatches::box(std::size_t patch, std::span<const Vec3> positions_mm) const {
    static_assert(sizeof(Vec3) == 3 * sizeof(double));
    Eigen::Array4d low = Eigen::Array4d::Constant(INFINITY), high = -low;
    Box last;
    for (const int v : vertices_of_[patch]) {
        if (static_cast<std::size_t>(v) + 1 == positions_mm.size()) {
            last.add(positions_mm[v]);
            continue;
        }
        const Eigen::Map<const Eigen::Array4d> numbers(positions_mm[v].data());
        low = low.min(numbers);
        high = high.max(numbers);
    }
    Box box{low.head<3>(), high.head<3>()};
    box.low = box.low.cwiseMin(last.low);
    box.high = box.high.cwiseMax(last.high);
    return box;
}

std::vector<std::vector<int>> SurfacePatches::triangles_in(
    std::span<const Box> boxes, std::span<const Vec3> positions_mm) const {
    std::vector<std::vector<int>> found(boxes.size());
    for (std::size_t p = 0; p < size(); ++p) {
        const Box of_patch = box(p, positions_mm);
        for (std::size_t b = 0; b < boxes.size(); ++b) {
            if (!of_patch.meets(boxes[b])) continue;
            for (const int t : triangles_of_[p])
                if (box_around(corners_of(triangles_[t], positions_mm)).meets(boxes[b]))
                    found[b].push_back(t);
        }
    }
    for (std::vector<int>& of_box : found) std::ranges::sort(of_box);
    return found;
}

std::vector<int> SurfacePatches::triangles_in(const Box& box,
                                              std::span<const Vec3> positions_mm) const {
    return std::move(triangles_in(std::span(&box, 1), positions_mm).front());
}

}  // namespace hepatica
