// SPDX-License-Identifier: GPL-3.0-or-later
// The coarse space of the skeleton preconditioner: an affine motion (12 modes) at every node of the
// centreline, interpolated linearly between neighbours. P maps the motions of nodes to those of
// vertices at the body's current shape; P^T A P has the graph of the tree.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/deform/solvers/block_matrix.h"
#include "core/deform/solvers/coarse_skeleton.h"

namespace hepatica {

// The affine motion of a node is four vectors: the velocity of its centre, and the changes of
// velocity over one radius along x, y and z. The coarse vectors and the coarse matrix have four
// entries (3-vectors, 3x3 blocks) per node.
constexpr int vectors_per_node = 4;

class AffineCoarseSpace {
  public:
    // `binding` binds the vertices to the skeleton; all later matrices must have this `pattern`.
    AffineCoarseSpace(const CoarseSkeleton& skeleton, SkeletonBinding binding,
                      const BlockMatrix& pattern);

    // Sets the current shape. Vertices marked as fixed (one mark each) do not move with the nodes.
    void set_shape(std::span<const Vec3> positions_mm, std::span<const char> fixed);

    // coarse = P^T fine
    void restrict_to_nodes(std::span<const Vec3> fine, std::vector<Vec3>& coarse) const;
    // fine += P coarse
    void add_motion(std::span<const Vec3> coarse, std::span<Vec3> fine) const;
    // The pattern of project()'s result, with all blocks zero.
    const BlockMatrix& coarse_pattern() const { return pattern_; }
    // coarse = P^T A P; `coarse` must have coarse_pattern().
    void project(const BlockMatrix& matrix, BlockMatrix& coarse) const;

    int node_count() const { return node_count_; }
    // Rows of P at the current shape: a vertex moves with two nodes and has a weight in each of the
    // four vectors of both.
    using Modes = Eigen::Vector4d;
    const SkeletonBinding& binding() const { return binding_; }
    std::span<const std::array<Modes, 2>> modes() const { return modes_; }
    // The centre of each node at the current shape: the weighted mean of its vertices.
    const std::vector<Vec3>& centres_mm() const { return centres_mm_; }

  private:
    // The vertices between two neighbouring nodes, and the columns that their part of P^T A P has.
    struct Group {
        std::array<int, 2> nodes{-1, -1};  // equal where there is only one
        std::vector<int> vertices;
        std::vector<int> columns;  // nodes that the vertices' rows of A reach, ascending
    };

    void project_group(const BlockMatrix& matrix, const Group& group,
                       std::vector<double>& product) const;
    void find_columns(Group& group, const BlockMatrix& pattern);
    void build_coarse_pattern();

    int node_count_ = 0;
    SkeletonBinding binding_;
    std::vector<double> radii_mm_;
    std::vector<Vec3> centres_mm_;
    std::vector<Group> groups_;
    std::vector<std::vector<int>> groups_of_;  // the groups of each node
    BlockMatrix pattern_;
    // For each block of A: the indices of its column's nodes in the columns of its row's group.
    std::vector<std::array<std::uint16_t, 2>> slots_;
    std::vector<std::array<Modes, 2>> modes_;  // weights of a vertex in the vectors of its nodes
};

}  // namespace hepatica
