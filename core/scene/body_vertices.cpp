// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/body_vertices.h"

#include <cmath>
#include <cstddef>
#include <numeric>

#include "core/deform/body/torn_body.h"
#include "core/mesh/surface.h"
#include "core/scene/pressed_stretches.h"

namespace hepatica {

namespace {

// 1 for the vertices within 1.3 radii of an end that is fixed.
std::vector<std::uint8_t> fixed_at_ends(const TetMesh& mesh, const VesselTree& tree,
                                        const std::vector<VertexPlace>& places, FixedEnds ends) {
    std::vector<std::uint8_t> fixed(mesh.vertices_mm.size(), 0);
    if (ends == FixedEnds::none) return fixed;
    const std::vector<int> degrees = node_degrees(tree);
    std::vector<std::vector<int>> vertices_of(tree.segments.size());
    for (std::size_t v = 0; v < places.size(); ++v)
        vertices_of[places[v].on_tree.segment].push_back(static_cast<int>(v));
    for (std::size_t s = 0; s < tree.segments.size(); ++s) {
        const VesselSegment& segment = tree.segments[s];
        const auto fix_around = [&](const Vec3& end, double radius_mm) {
            for (const int v : vertices_of[s])
                if ((mesh.vertices_mm[v] - end).norm() < 1.3 * radius_mm) fixed[v] = 1;
        };
        if (segment.parent < 0 && degrees[segment.proximal_node] == 1)
            fix_around(segment.points_mm.front(), segment.radii_mm.front());
        if (ends == FixedEnds::all && degrees[segment.distal_node] == 1)
            fix_around(segment.points_mm.back(), segment.radii_mm.back());
    }
    return fixed;
}

}  // namespace

BodyVertices::BodyVertices(const TetMesh& whole, const VesselTree& tree, FixedEnds ends)
    : rest_mm_(whole.vertices_mm),
      places_(places_of(whole.vertices_mm, tree)),
      fixed_(fixed_at_ends(whole, tree, places_, ends)),
      on_surface_(surface_of(whole).body_vertex) {}

void BodyVertices::follow(const TetMesh& whole, const TornTopology* torn) {
    const std::uint64_t version = torn != nullptr ? torn->version() : 1;
    if (version == followed_) return;
    areas_mm2_.clear();
    const std::size_t count = whole.vertices_mm.size();
    std::vector<int> parents(count);
    std::iota(parents.begin(), parents.end(), 0);
    if (torn != nullptr) parents.assign(torn->parents().begin(), torn->parents().end());
    // Vertices of another tear have other parents.
    rest_mm_.resize(count);
    fixed_.resize(count);
    places_.resize(count);
    inherit(parents, rest_mm_);
    inherit(parents, fixed_);
    inherit(parents, places_);
    std::vector<std::uint8_t> on_surface(parents.size(), 0);
    for (const auto& triangle : present_surface(whole, torn))
        for (const int v : triangle) on_surface[v] = 1;
    on_surface_.clear();
    for (std::size_t v = 0; v < on_surface.size(); ++v)
        if (on_surface[v]) on_surface_.push_back(static_cast<int>(v));
    followed_ = version;  // at the end: where memory lacks, the next call tries again
}

const std::vector<double>& BodyVertices::areas_mm2(const TetMesh& whole,
                                                   const TornTopology* torn) const {
    if (areas_mm2_.empty()) areas_mm2_ = vertex_areas_mm2(present_surface(whole, torn), rest_mm_);
    return areas_mm2_;
}

int BodyVertices::nearest(const Vec3& point_mm, std::span<const Vec3> positions_mm) const {
    const auto squared = [&](int v) { return (positions_mm[v] - point_mm).squaredNorm(); };
    int nearest = on_surface_.front();
    for (const int v : on_surface_)
        if (squared(v) < squared(nearest)) nearest = v;
    return nearest;
}

Vec3 BodyVertices::axis_near(const VertexPlace& place, std::span<const Vec3> positions_mm) const {
    Vec3 sum = Vec3::Zero();
    int count = 0;
    for (std::size_t v = 0; v < places_.size(); ++v) {
        const TreePoint& other = places_[v].on_tree;
        if (other.segment != place.on_tree.segment ||
            std::abs(other.arclength_mm - place.on_tree.arclength_mm) > place.radius_mm)
            continue;
        sum += positions_mm[v];
        ++count;
    }
    return sum / count;
}

std::vector<std::array<int, 3>> present_surface(const TetMesh& whole, const TornTopology* torn) {
    return torn != nullptr ? torn->surface() : boundary_triangles(whole);
}

}  // namespace hepatica
