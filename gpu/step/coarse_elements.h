// SPDX-License-Identifier: GPL-3.0-or-later
// How P^T A P is added up on a device: as a stiffness matrix is from elements. An element of the
// coarse grid is what a few vertices between the same two nodes give to these; it is computed by
// one block of threads, and every block of the matrix then gathers what its elements hold for it.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/deform/step/assembly_plan.h"
#include "gpu/kernels/coarse_kernels.h"

namespace hepatica::gpu {

struct CoarseElements {
    std::vector<CoarseElement> element;
    std::vector<int> vertex;      // of each element
    std::vector<int> part_begin;  // of each pair of nodes
    std::vector<int> part;        // of elements, see CoarseElement
};

// `nodes` are those of each vertex. Of the pairs, which are ordered by their own node, each
// is found once. A node that no vertex has in common with the pair's own gives it nothing.
CoarseElements plan_coarse_elements(std::span<const std::array<int, 2>> nodes,
                                    const AssemblyPlan& plan, std::span<const NodePair> pairs);

}  // namespace hepatica::gpu
