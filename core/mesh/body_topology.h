// SPDX-License-Identifier: GPL-3.0-or-later
// The vertices of the displayed body, the triangles of its surface, and the vertex from which each
// vertex was split. This is the only place where these change. Values kept per vertex elsewhere
// follow the map of parents; a copy is out of date when the version differs.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace hepatica {

// Not thread-safe, except for the triangles: they are never changed, only replaced.
class BodyTopology {
  public:
    using Triangles = std::vector<std::array<int, 3>>;

    // An unsplit body: every vertex is its own parent. Throws std::logic_error if a triangle names
    // a vertex that does not exist.
    BodyTopology(std::size_t vertex_count, Triangles triangles);

    // 1 at first; increases with every call of split() and become().
    std::uint64_t version() const { return version_; }
    std::size_t vertex_count() const { return parents_.size(); }
    const std::shared_ptr<const Triangles>& triangles() const { return triangles_; }
    // The vertex from which this one was split, which has a smaller number; itself if it is
    // original.
    int parent(int vertex) const { return parents_[vertex]; }

    // Replaces the body by one with these parents, one per vertex as parent() returns them, and
    // this surface: torn, or whole again. Throws std::logic_error, and changes nothing, if a parent
    // or a vertex of a triangle does not exist.
    void become(std::vector<int> parents, Triangles triangles);

    // Appends one vertex for each entry of `parents`, the vertex that it is split from (an older
    // one or one before it in the list); `triangles` is the whole new surface. Throws
    // std::logic_error, and changes nothing, if a parent or a vertex of a triangle does not exist:
    // that is a bug of the caller.
    void split(std::span<const int> parents, Triangles triangles);

  private:
    std::uint64_t version_ = 1;
    std::vector<int> parents_;  // per vertex
    std::shared_ptr<const Triangles> triangles_;
};

// Resizes `per_vertex` to the body and gives every split vertex its parent's value, also one that
// had a value of its own.
template <class T>
void inherit(const BodyTopology& topology, std::vector<T>& per_vertex) {
    per_vertex.resize(topology.vertex_count());
    for (std::size_t v = 0; v < per_vertex.size(); ++v)
        per_vertex[v] = per_vertex[topology.parent(static_cast<int>(v))];
}

}  // namespace hepatica
