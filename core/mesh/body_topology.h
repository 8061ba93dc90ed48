// SPDX-License-Identifier: GPL-3.0-or-later
// Which vertices the body that is shown has, which triangles its surface has, and from which vertex
// each one was split: the one place where that changes. What is kept per vertex elsewhere follows
// the map of parents, and a copy is out of date when the version is another.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace hepatica {

// Not thread-safe, but for the triangles: they are never changed, only replaced.
class BodyTopology {
  public:
    using Triangles = std::vector<std::array<int, 3>>;

    // A body of which nothing was split: every vertex is its own parent. Throws std::logic_error
    // where a triangle names a vertex that is not there.
    BodyTopology(std::size_t vertex_count, Triangles triangles);

    // 1 at first; another after every split.
    std::uint64_t version() const { return version_; }
    std::size_t vertex_count() const { return parents_.size(); }
    const std::shared_ptr<const Triangles>& triangles() const { return triangles_; }
    // The vertex from which this one was split, a smaller number; itself where it was there from
    // the beginning.
    int parent(int vertex) const { return parents_[vertex]; }

    // A body with these parents, one per vertex as parent() gives them, and this surface: torn, or
    // whole again. Throws std::logic_error, and changes nothing, where one does not exist.
    void become(std::vector<int> parents, Triangles triangles);

    // Adds one vertex behind the others for each entry of `parents`, the vertex that it is split
    // from (an older one or one before it in the list); `triangles` is the whole new surface.
    // Throws std::logic_error, and changes nothing, where a parent or a vertex of a triangle is not
    // there: a new vertex without a parent is a bug of the caller.
    void split(std::span<const int> parents, Triangles triangles);

  private:
    std::uint64_t version_ = 1;
    std::vector<int> parents_;  // per vertex
    std::shared_ptr<const Triangles> triangles_;
};

// Gives every vertex that was split off its parent's value; those that are gone since `per_vertex`
// was made lose theirs.
template <class T>
void inherit(const BodyTopology& topology, std::vector<T>& per_vertex) {
    per_vertex.resize(topology.vertex_count());
    for (std::size_t v = 0; v < per_vertex.size(); ++v)
        per_vertex[v] = per_vertex[topology.parent(static_cast<int>(v))];
}

}  // namespace hepatica
