// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/rounded_surface.h"

#include <algorithm>
#include <cstddef>

namespace hepatica {
namespace {

using Vec3f = Eigen::Vector3f;

// Share of the way from the middle of an edge to the mean of its projections onto the tangent
// planes at its ends. On a circle of radius r the middle of a chord of length c lies c^2/8r below
// the arc and c^2/4r below the tangent planes, so a share of one half puts it onto a sphere or tube
// to second order in c.
constexpr float roundness = 0.5f;

struct EdgeUse {
    std::array<int, 2> edge;  // lower vertex first
    int triangle;
    int side;
};

Eigen::Map<const Vec3f> at(const std::vector<float>& values, int index) {
    return Eigen::Map<const Vec3f>(values.data() + 3 * static_cast<std::size_t>(index));
}

}  // namespace

void RoundedSurface::set_topology(const std::vector<std::array<int, 3>>& triangles,
                                  std::size_t vertex_count,
                                  const std::vector<std::array<int, 2>>& creases) {
    corner_count_ = vertex_count;
    std::vector<EdgeUse> uses;
    uses.reserve(3 * triangles.size());
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        for (int side = 0; side < 3; ++side) {
            const int a = triangles[t][static_cast<std::size_t>(side)];
            const int b = triangles[t][static_cast<std::size_t>((side + 1) % 3)];
            uses.push_back({{std::min(a, b), std::max(a, b)}, static_cast<int>(t), side});
        }
    }
    std::sort(uses.begin(), uses.end(), [](const EdgeUse& a, const EdgeUse& b) {
        return a.edge != b.edge ? a.edge < b.edge : a.triangle < b.triangle;
    });
    edges_.clear();
    std::vector<std::array<int, 3>> middles(triangles.size());
    for (const EdgeUse& use : uses) {
        if (edges_.empty() || edges_.back() != use.edge) edges_.push_back(use.edge);
        middles[static_cast<std::size_t>(use.triangle)][static_cast<std::size_t>(use.side)] =
            static_cast<int>(corner_count_ + edges_.size()) - 1;
    }
    find_seams(creases);
    triangles_.clear();
    triangles_.reserve(4 * triangles.size());
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        const auto& [a, b, c] = triangles[t];
        const auto& [ab, bc, ca] = middles[t];
        triangles_.insert(triangles_.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    positions_mm_.assign(3 * this->vertex_count(), 0.0f);
    normals_.assign(3 * this->vertex_count(), 0.0f);
}

void RoundedSurface::find_seams(const std::vector<std::array<int, 2>>& creases) {
    seams_.clear();
    const auto twin_of = [&creases](int bare) {
        const auto crease =
            std::ranges::lower_bound(creases, bare, {}, [](const auto& pair) { return pair[1]; });
        return crease != creases.end() && (*crease)[1] == bare ? (*crease)[0] : -1;
    };
    for (std::size_t e = 0; e < edges_.size() && !creases.empty(); ++e) {
        const int a = twin_of(edges_[e][0]), b = twin_of(edges_[e][1]);
        if (a < 0 || b < 0) continue;
        const std::array<int, 2> outer{std::min(a, b), std::max(a, b)};
        const auto found = std::ranges::lower_bound(edges_, outer);
        if (found != edges_.end() && *found == outer)
            seams_.push_back({static_cast<std::size_t>(found - edges_.begin()), e});
    }
}

void RoundedSurface::update(const SurfaceGeometry& surface) {
    std::copy(surface.positions_mm().begin(), surface.positions_mm().end(), positions_mm_.begin());
    std::copy(surface.normals().begin(), surface.normals().end(), normals_.begin());
    for (std::size_t e = 0; e < edges_.size(); ++e) {
        const auto& [a, b] = edges_[e];
        const Vec3f middle = 0.5f * (at(positions_mm_, a) + at(positions_mm_, b));
        const Vec3f above_a = at(normals_, a) * at(normals_, a).dot(middle - at(positions_mm_, a));
        const Vec3f above_b = at(normals_, b) * at(normals_, b).dot(middle - at(positions_mm_, b));
        Vec3f normal = at(normals_, a) + at(normals_, b);
        const float length = normal.norm();
        normal = length > 0.0f ? Vec3f(normal / length) : Vec3f(at(normals_, a));
        const std::size_t place = 3 * (corner_count_ + e);
        Eigen::Map<Vec3f>(positions_mm_.data() + place) =
            middle - roundness * 0.5f * (above_a + above_b);
        Eigen::Map<Vec3f>(normals_.data() + place) = normal;
    }
    for (const auto& [outer, bare] : seams_)
        Eigen::Map<Vec3f>(positions_mm_.data() + 3 * (corner_count_ + bare)) =
            at(positions_mm_, static_cast<int>(corner_count_ + outer));
}

}  // namespace hepatica
