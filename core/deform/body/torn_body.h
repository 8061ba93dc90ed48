// SPDX-License-Identifier: GPL-3.0-or-later
// What a tear has made of a body, from the whole body on: more vertices, other corners, and what
// binds the parted joints. Rest shapes and elements stay as they are.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/deform/body/body.h"
#include "core/tear/tearing.h"

namespace hepatica {

struct TornBody {
    std::vector<int> parents;  // per vertex: which one it was split from, or itself
    std::vector<std::array<int, 4>> tetrahedra;
    std::vector<std::array<int, 2>> parted_pairs;  // see Body
    SofteningLaw law;
    std::vector<SofteningTie> ties;
};

TornBody torn_body_of(const Tearing& tearing);

// The description of the torn body: new vertices lie where their parents lie at rest, and are fixed
// where those are.
BodyDescription torn(const BodyDescription& whole, const TornBody& tear);

// One entry per vertex: every one that is missing becomes its parent's, what is too much goes.
template <class T>
void inherit(std::span<const int> parents, std::vector<T>& per_vertex) {
    if (per_vertex.size() > parents.size()) per_vertex.resize(parents.size());
    while (per_vertex.size() < parents.size())
        per_vertex.push_back(T(per_vertex[parents[per_vertex.size()]]));
}

// The vertex among the first `count` from which each was split; where there were more of them
// before, itself.
std::vector<int> nodes_before(std::span<const int> parents, int count);

}  // namespace hepatica
