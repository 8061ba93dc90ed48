// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/surface_geometry.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace hepatica {
namespace {

using Vec3f = Eigen::Vector3f;

Eigen::Map<const Vec3f> vertex(const std::vector<float>& values, int index) {
    return Eigen::Map<const Vec3f>(values.data() + 3 * static_cast<std::size_t>(index));
}

// The interval of distances along a ray on the drawn side of the clip plane.
struct Stretch {
    double begin = 0.0;
    double end = std::numeric_limits<double>::infinity();
};

Stretch stretch_drawn(const Vec3& origin_mm, const Vec3& direction,
                      const std::optional<ClipPlane>& clip) {
    Stretch drawn;
    if (!clip) return drawn;
    const double inside_mm = (origin_mm - clip->point_mm).dot(clip->inward);
    const double approach = direction.dot(clip->inward);
    if (approach > 0.0)
        drawn.begin = std::max(0.0, -inside_mm / approach);
    else if (approach < 0.0)
        drawn.end = -inside_mm / approach;  // below 0 where nothing is drawn
    else if (inside_mm < 0.0)
        drawn.end = 0.0;
    return drawn;
}

}  // namespace

SurfaceGeometry::Change SurfaceGeometry::update(const Frame& frame) {
    const bool rebuilt = frame.surface != source_ || frame.topology_version != topology_version_;
    if (rebuilt) rebuild(frame);
    bool moved = rebuilt;
    Vec3f lower = Vec3f::Constant(std::numeric_limits<float>::max());
    Vec3f upper = -lower;
    for (std::size_t v = 0; v < frame_vertices_.size(); ++v) {
        const Vec3f position = vertex(frame.positions_mm, frame_vertices_[v]);
        Eigen::Map<Vec3f> mine(positions_mm_.data() + 3 * v);
        moved = moved || mine != position;
        mine = position;
        lower = lower.cwiseMin(position);
        upper = upper.cwiseMax(position);
    }
    lower_mm_ = lower.cast<double>();
    upper_mm_ = upper.cast<double>();
    if (!moved) return Change::none;
    compute_normals();
    return rebuilt ? Change::topology : Change::positions;
}

void SurfaceGeometry::rebuild(const Frame& frame) {
    source_ = frame.surface;
    topology_version_ = frame.topology_version;
    triangles_.assign(source_ ? source_->size() : 0, {});
    frame_vertices_.clear();
    creases_.clear();
    const auto bare = frame.tear ? frame.tear->bare : nullptr;
    const bool any_bare = bare && bare->size() == triangles_.size();
    std::vector<int> outer(frame.positions_mm.size() / 3, -1);
    add_triangles(outer, [&](std::size_t t) { return !any_bare || (*bare)[t] == 0; });
    outer_count_ = frame_vertices_.size();
    if (any_bare) {
        std::vector<int> inner(outer.size(), -1);
        add_triangles(inner, [&](std::size_t t) { return (*bare)[t] != 0; });
        for (std::size_t v = outer_count_; v < frame_vertices_.size(); ++v)
            if (const int twin = outer[static_cast<std::size_t>(frame_vertices_[v])]; twin >= 0)
                creases_.push_back({twin, static_cast<int>(v)});
    }
    positions_mm_.assign(3 * frame_vertices_.size(), 0.0f);
    normals_.assign(3 * frame_vertices_.size(), 0.0f);
}

// Renumbers the triangles that are chosen; `surface_vertex` has the number of each vertex of the
// frame, or -1.
template <class Chosen>
void SurfaceGeometry::add_triangles(std::vector<int>& surface_vertex, const Chosen& chosen) {
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
        if (!chosen(t)) continue;
        for (std::size_t c = 0; c < 3; ++c) {
            const int vertex = (*source_)[t][c];
            int& place = surface_vertex.at(static_cast<std::size_t>(vertex));
            if (place < 0) {
                place = static_cast<int>(frame_vertices_.size());
                frame_vertices_.push_back(vertex);
            }
            triangles_[t][c] = place;
        }
    }
}

void SurfaceGeometry::compute_normals() {
    std::fill(normals_.begin(), normals_.end(), 0.0f);
    for (const auto& [a, b, c] : triangles_) {
        const Vec3f origin = vertex(positions_mm_, a);
        // The cross product's length is twice the triangle's area, which weights the normals by
        // area.
        const Vec3f normal =
            (vertex(positions_mm_, b) - origin).cross(vertex(positions_mm_, c) - origin);
        for (const int corner : {a, b, c}) {
            Eigen::Map<Vec3f>(normals_.data() + 3 * static_cast<std::size_t>(corner)) += normal;
        }
    }
    for (std::size_t v = 0; v < frame_vertices_.size(); ++v) {
        Eigen::Map<Vec3f> normal(normals_.data() + 3 * v);
        const float length = normal.norm();
        normal = length > 0.0f ? Vec3f(normal / length) : Vec3f(0, 0, 1);
    }
}

SurfacePick pick_surface(const SurfaceGeometry& surface, const Vec3& origin_mm,
                         const Vec3& direction, const std::optional<ClipPlane>& clip) {
    const Stretch drawn = stretch_drawn(origin_mm, direction, clip);
    SurfacePick best;
    best.distance = drawn.end;
    const auto& triangles = surface.triangles();
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        const Vec3 a = vertex(surface.positions_mm(), triangles[t][0]).cast<double>();
        const Vec3 ab = vertex(surface.positions_mm(), triangles[t][1]).cast<double>() - a;
        const Vec3 ac = vertex(surface.positions_mm(), triangles[t][2]).cast<double>() - a;
        // Moeller and Trumbore 1997.
        const Vec3 p = direction.cross(ac);
        const double determinant = ab.dot(p);
        if (determinant == 0.0) continue;
        const Vec3 s = origin_mm - a;
        const double u = s.dot(p) / determinant;
        if (!(u >= 0.0 && u <= 1.0)) continue;
        const Vec3 q = s.cross(ab);
        const double v = direction.dot(q) / determinant;
        if (!(v >= 0.0 && u + v <= 1.0)) continue;
        const double distance = ac.dot(q) / determinant;
        if (!(distance > drawn.begin && distance < best.distance)) continue;
        best.distance = distance;
        best.triangle = static_cast<int>(t);
        best.weights = {1.0 - u - v, u, v};
    }
    if (best.triangle < 0) return best;
    best.position_mm = origin_mm + best.distance * direction;
    const auto& corners = triangles[static_cast<std::size_t>(best.triangle)];
    for (std::size_t c = 0; c < 3; ++c) {
        best.vertices[c] = surface.frame_vertices()[static_cast<std::size_t>(corners[c])];
    }
    const auto heaviest = std::max_element(best.weights.begin(), best.weights.end());
    best.nearest_vertex = best.vertices[static_cast<std::size_t>(heaviest - best.weights.begin())];
    return best;
}

}  // namespace hepatica
