// SPDX-License-Identifier: GPL-3.0-or-later
// Which tetrahedra are connected at which vertices while joints part. A vertex whose tetrahedra
// fall into several groups that no joint connects is split, one vertex per group, so that nothing
// is ever connected by a point or an edge alone. Shapes and masses are not its concern.
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
    // Starts whole. Every vertex of the mesh must belong to a tetrahedron.
    explicit TornTopology(const TetMesh& mesh);

    std::span<const Joint> joints() const { return *joints_; }
    std::span<const std::array<int, 4>> tetrahedra() const { return tetrahedra_; }
    // The vertex that each vertex was split from: itself for those of the mesh, otherwise a smaller
    // number.
    std::span<const int> parents() const { return parents_; }
    int vertex_count() const { return static_cast<int>(parents_.size()); }
    // Differs after every change.
    std::uint64_t version() const { return version_; }
    // The boundary, as boundary_triangles() gives it, but without a sort.
    std::vector<std::array<int, 3>> surface() const;
    // Of each triangle of surface(): 1 where it is a side of a joint, 0 on the surface of the whole
    // mesh.
    std::vector<std::uint8_t> bare_faces() const;
    bool parted(int joint) const { return parted_[joint] != 0; }
    // The joint opposite a corner of a tetrahedron; -1: none, on the surface of the whole mesh.
    int joint_opposite(int tetrahedron, int corner) const {
        return (*joint_opposite_)[tetrahedron][corner];
    }
    // The vertices at corner k of a joint, on its first and on its second side.
    std::array<int, 2> sides(const Joint& joint, int k) const;

    // The joints at a vertex that have not parted, ascending.
    std::vector<int> joints_at(int vertex) const;

    // Parts these joints and splits the vertices that this frees. The group with the largest volume
    // keeps the number; the others get new ones. `volume_mm3`: rest volume of each tetrahedron.
    // Costs only the surroundings of the joints.
    void part(std::span<const int> joints, std::span<const double> volume_mm3);

    // Restores the joints, vertices and corners that this class gave before. Throws InputError and
    // changes nothing where they are not of this mesh.
    void restore(std::span<const int> parted, std::span<const int> parents,
                 std::span<const std::array<int, 4>> tetrahedra);

    // Number of pieces: tetrahedra that share a vertex, and vertices that `ties` hold together.
    int pieces(std::span<const std::array<int, 2>> ties) const;
    // The piece of each vertex, identified by its first vertex.
    std::vector<int> piece_of_vertices(std::span<const std::array<int, 2>> ties) const;

  private:
    // Calls visit(tetrahedron, corner opposite the face, joint or -1) for each face of surface().
    template <class Visit>
    void for_each_open_face(const Visit& visit) const;
    void find_tetrahedra_of_vertices();
    void split(int vertex, std::span<const double> volume_mm3);

    std::shared_ptr<const std::vector<Joint>> joints_;
    // The joint opposite each corner of each tetrahedron; -1: none.
    std::shared_ptr<const std::vector<std::array<int, 4>>> joint_opposite_;
    std::uint64_t version_ = 1;
    int whole_vertices_;
    std::vector<std::array<int, 4>> tetrahedra_;
    std::vector<std::vector<int>> tetrahedra_of_;  // of each vertex, ascending
    std::vector<int> parents_;
    std::vector<std::uint8_t> parted_;
};

}  // namespace hepatica
