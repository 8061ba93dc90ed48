// SPDX-License-Identifier: GPL-3.0-or-later
// The features of a surface that can meet: its vertices and triangles, and its edges. Each vertex
// and each edge belongs to the first triangle that has it, so that pairs of triangles enumerate
// every pair of features once. Each has a share of the surface area at rest, a third of the
// triangles around it. The surfaces of fixed obstacles may be included; then only moving and fixed
// surfaces can meet.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "core/contact/surface_patches.h"

namespace hepatica {

struct FeaturePair {
    bool of_edges = false;       // otherwise a vertex and a triangle
    int first = 0, second = 0;   // the vertex and the triangle, or the edges, first < second
    std::array<int, 4> nodes{};  // of the first, then of the second
};

// The distance of its two features.
double distance_mm(const FeaturePair& pair, std::span<const Vec3> positions_mm);

// Whether a pair of patches does not count. A pair of features counts if some pair of triangles
// that contain them is of patches that count.
using LeftOut = std::function<bool(int patch, int other)>;

// What a surface belongs to: a moving body; a solid obstacle that nothing may enter; or a shell, a
// closed obstacle that nothing may leave.
enum class SurfaceKind : std::uint8_t { moving, solid, shell };

// Thread safety: const access only.
class SurfaceFeatures {
  public:
    // kind_of_node: one per node, the same for all nodes of a piece; empty: all are moving.
    SurfaceFeatures(SurfacePatches surface, std::span<const Vec3> rest_positions_mm,
                    std::span<const SurfaceKind> kind_of_node = {});

    const SurfacePatches& surface() const { return surface_; }
    const std::vector<std::array<int, 2>>& edges() const { return edges_; }
    // The nodes on the surface, ascending.
    const std::vector<int>& nodes() const { return nodes_; }

    std::span<const int> nodes_owned_by(int triangle) const { return owned_nodes_[triangle]; }
    std::span<const int> edges_owned_by(int triangle) const { return owned_edges_[triangle]; }

    double area_of_node_mm2(int node) const { return node_area_mm2_[node]; }
    double area_of_edge_mm2(int edge) const { return edge_area_mm2_[edge]; }

    int patch_of(int triangle) const { return patch_of_[triangle]; }
    // The patches of all triangles that contain the feature, ascending: on a border there are
    // several.
    std::span<const int> patches_of_node(int node) const { return patches_of_node_[node]; }
    std::span<const int> patches_of_edge(int edge) const { return patches_of_edge_[edge]; }
    // The patches with a higher number that share a node with this one, ascending.
    std::span<const int> neighbours_above(int patch) const { return neighbours_above_[patch]; }
    bool neighbours(int patch, int other) const;

    bool counts(const FeaturePair& pair, const LeftOut& left_out) const;

    std::size_t bytes() const;

    // Connected components of triangles that share nodes, numbered from 0.
    int pieces() const { return pieces_; }
    int piece_of_patch(int patch) const { return piece_of_patch_[patch]; }
    std::span<const int> patches_of_piece(int piece) const { return patches_of_piece_[piece]; }

    // Whether there are obstacles, and the kind of a piece or a patch.
    bool beside_obstacles() const { return beside_obstacles_; }
    SurfaceKind kind_of_piece(int piece) const { return kind_of_piece_[piece]; }
    SurfaceKind kind_of_patch(int patch) const { return kind_of_piece_[piece_of_patch_[patch]]; }
    // How far an edge or a vertex of an obstacle sticks out towards the body: from 0 in a flat or
    // concave place to 1 where the normals of its triangles differ by 60 degrees or more.
    double sharpness_of_edge(int edge) const { return edge_sharpness_[edge]; }
    double sharpness_of_node(int node) const { return node_sharpness_[node]; }
    // False for two fixed patches, and beside obstacles also for two moving ones.
    bool may_meet(int patch, int other) const {
        return !beside_obstacles_ || (kind_of_patch(patch) == SurfaceKind::moving) !=
                                         (kind_of_patch(other) == SurfaceKind::moving);
    }

  private:
    void find_edges(std::span<const double> area_mm2);
    void find_pieces();
    void find_kinds(std::span<const SurfaceKind> kind_of_node);
    void find_sharpness(std::span<const SurfaceKind> kind_of_node,
                        std::span<const Vec3> positions_mm);
    void find_borders();

    SurfacePatches surface_;
    std::vector<std::array<int, 2>> edges_;
    std::vector<int> nodes_;
    std::vector<std::vector<int>> owned_nodes_, owned_edges_;
    std::vector<int> patch_of_;  // of each triangle
    std::vector<std::vector<int>> patches_of_node_, patches_of_edge_, neighbours_above_;
    std::vector<double> node_area_mm2_, edge_area_mm2_;
    std::vector<int> piece_of_patch_;
    std::vector<std::vector<int>> patches_of_piece_;
    std::vector<SurfaceKind> kind_of_piece_;
    std::vector<double> edge_sharpness_, node_sharpness_;  // beside obstacles
    int pieces_ = 0;
    bool beside_obstacles_ = false;
};

}  // namespace hepatica
