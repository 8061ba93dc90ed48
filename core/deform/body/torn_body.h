// SPDX-License-Identifier: GPL-3.0-or-later
// What a tear changes in a body, always relative to the whole body: more vertices, other corners of
// its tetrahedra, and the ties between parted joints. Rest shapes and elements stay as they are.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/deform/body/body.h"
#include "core/tear/tearing.h"

namespace hepatica {

struct TornBody {
    std::vector<int> parents;  // per vertex: the one that it was split from, or itself
    std::vector<std::array<int, 4>> tetrahedra;
    std::vector<std::array<int, 2>> parted_pairs;  // see Body
    SofteningLaw law;
    std::vector<SofteningTie> ties;
};

TornBody torn_body_of(const Tearing& tearing);

// The description of the torn body: a new vertex has the rest position of its parent and is fixed
// where the parent is.
BodyDescription torn(const BodyDescription& whole, const TornBody& tear);

// Resizes `per_vertex` to one entry per vertex: a missing entry is copied from the vertex's parent,
// surplus entries are removed.
template <class T>
void inherit(std::span<const int> parents, std::vector<T>& per_vertex) {
    if (per_vertex.size() > parents.size()) per_vertex.resize(parents.size());
    while (per_vertex.size() < parents.size())
        per_vertex.push_back(T(per_vertex[parents[per_vertex.size()]]));
}

// For every vertex, the ancestor among the first `count` vertices; a vertex below `count` is its
// own.
std::vector<int> nodes_before(std::span<const int> parents, int count);

}  // namespace hepatica
