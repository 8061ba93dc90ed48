// SPDX-License-Identifier: GPL-3.0-or-later
// What of a surface can meet what: its vertices and triangles, and its edges. Each vertex and each
// edge belongs to the first triangle that has it, so that pairs of triangles give every pair of
// features once. Each has a share of the surface at rest, a third of the triangles around it.
#pragma once

#include <vector>

#include "core/contact/surface_patches.h"

namespace hepatica {

// Thread safety: const access only.
class SurfaceFeatures {
  public:
    SurfaceFeatures(SurfacePatches surface, std::span<const Vec3> rest_positions_mm);

    const SurfacePatches& surface() const { return surface_; }
    const std::vector<std::array<int, 2>>& edges() const { return edges_; }
    // The nodes on the surface, ascending.
    const std::vector<int>& nodes() const { return nodes_; }

    std::span<const int> nodes_owned_by(int triangle) const { return owned_nodes_[triangle]; }
    std::span<const int> edges_owned_by(int triangle) const { return owned_edges_[triangle]; }

    double area_of_node_mm2(int node) const { return node_area_mm2_[node]; }
    double area_of_edge_mm2(int edge) const { return edge_area_mm2_[edge]; }

    int patch_of(int triangle) const { return patch_of_[triangle]; }
    // The patches of the triangles that own the two features.
    std::array<int, 2> patches_of_vertex_triangle(int node, int triangle) const {
        return {patch_of_[owner_of_node_[node]], patch_of_[triangle]};
    }
    std::array<int, 2> patches_of_edges(int edge, int other) const {
        return {patch_of_[owner_of_edge_[edge]], patch_of_[owner_of_edge_[other]]};
    }

    std::size_t bytes() const;

    // Triangles that share a node are of one piece; pieces are counted from 0.
    int pieces() const { return pieces_; }
    int piece_of_patch(int patch) const { return piece_of_patch_[patch]; }

  private:
    void find_edges(std::span<const double> area_mm2);
    void find_pieces();

    SurfacePatches surface_;
    std::vector<std::array<int, 2>> edges_;
    std::vector<int> nodes_;
    std::vector<std::vector<int>> owned_nodes_, owned_edges_;
    std::vector<int> owner_of_node_, owner_of_edge_, patch_of_;  // triangles, triangles, patches
    std::vector<double> node_area_mm2_, edge_area_mm2_;
    std::vector<int> piece_of_patch_;
    int pieces_ = 0;
};

}  // namespace hepatica
