// SPDX-License-Identifier: GPL-3.0-or-later
// Which tetrahedra hang together at which vertices, while joints part. A vertex around which the
// tetrahedra fall into several groups that no joint holds together is split, one vertex for each:
// so nothing ever hangs by a point or an edge alone. Shapes and masses are nothing of its business.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/tear/joint.h"

namespace hepatica {

// Not thread-safe.
class TornTopology {
  public:
    // Whole. Every vertex of the mesh belongs to a tetrahedron.
    explicit TornTopology(const TetMesh& mesh);

    std::span<const Joint> joints() const { return *joints_; }
    std::span<const std::array<int, 4>> tetrahedra() const { return tetrahedra_; }
    // The vertex from which each was split: itself for those of the mesh, a smaller number for all
    // others.
    std::span<const int> parents() const { return parents_; }
    int vertex_count() const { return static_cast<int>(parents_.size()); }
    // Another after every change.
    std::uint64_t version() const { return version_; }
    // Its boundary, as boundary_triangles() has it, without a sort.
    std::vector<std::array<int, 3>> surface() const;
    bool parted(int joint) const { return parted_[joint] != 0; }
    // The vertices at corner k of a joint, on its first and on its second side.
    std::array<int, 2> sides(const Joint& joint, int k) const;

    // The joints at a vertex that have not parted, ascending.
    std::vector<int> joints_at(int vertex) const;

    // Parts these joints, and splits the vertices that this sets free, in one transaction. The
    // group with the largest volume keeps the number; the others get the next ones. `volume_mm3` is
    // that of each tetrahedron at rest. Costs what lies around the joints.
    void part(std::span<const int> joints, std::span<const double> volume_mm3);

    // Takes what was torn before, as read from this class: joints, vertices and corners. Throws
    // InputError where that is not of this mesh.
    void restore(std::span<const int> parted, std::span<const int> parents,
                 std::span<const std::array<int, 4>> tetrahedra);

    // Pieces of tetrahedra that share a vertex, and of vertices that `ties` hold together.
    int pieces(std::span<const std::array<int, 2>> ties) const;
    // The piece of each vertex, named by its first vertex.
    std::vector<int> piece_of_vertices(std::span<const std::array<int, 2>> ties) const;

  private:
    void find_tetrahedra_of_vertices();
    void split(int vertex, std::span<const double> volume_mm3);

    std::shared_ptr<const std::vector<Joint>> joints_;
    std::shared_ptr<const std::vector<std::array<int, 4>>> joint_opposite_;  // to each corner; -1
    std::uint64_t version_ = 1;
    int whole_vertices_;
    std::vector<std::array<int, 4>> tetrahedra_;
    std::vector<std::vector<int>> tetrahedra_of_;  // each vertex, ascending
    std::vector<int> parents_;
    std::vector<std::uint8_t> parted_;
};

}  // namespace hepatica
