// SPDX-License-Identifier: GPL-3.0-or-later
// Checks of indices; a new state is complete before it replaces the old one.
#include "core/mesh/body_topology.h"

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <utility>

namespace hepatica {

namespace {

void require_vertices(const BodyTopology::Triangles& triangles, std::size_t vertex_count) {
    const auto exists = [&](int vertex) {
        return vertex >= 0 && static_cast<std::size_t>(vertex) < vertex_count;
    };
    for (const std::array<int, 3>& triangle : triangles)
        if (!std::ranges::all_of(triangle, exists))
            throw std::logic_error("a triangle of the surface names a vertex that is not there");
}

}  // namespace

BodyTopology::BodyTopology(std::size_t vertex_count, Triangles triangles)
    : parents_(vertex_count), triangles_(std::make_shared<const Triangles>(std::move(triangles))) {
    require_vertices(*triangles_, vertex_count);
    std::iota(parents_.begin(), parents_.end(), 0);
}

void BodyTopology::become(std::vector<int> parents, Triangles triangles) {
    for (std::size_t v = 0; v < parents.size(); ++v)
        if (parents[v] < 0 || static_cast<std::size_t>(parents[v]) > v)
            throw std::logic_error("a vertex was split from one that is not there");
    require_vertices(triangles, parents.size());
    triangles_ = std::make_shared<const Triangles>(std::move(triangles));
    parents_ = std::move(parents);
    ++version_;
}

void BodyTopology::split(std::span<const int> parents, Triangles triangles) {
    std::vector<int> all = parents_;
    for (const int parent : parents) {
        if (parent < 0 || static_cast<std::size_t>(parent) >= all.size())
            throw std::logic_error("a vertex was split from one that is not there");
        all.push_back(parent);
    }
    require_vertices(triangles, all.size());
    triangles_ = std::make_shared<const Triangles>(std::move(triangles));
    parents_ = std::move(all);
    ++version_;
}

}  // namespace hepatica
