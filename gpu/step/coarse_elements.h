// SPDX-License-Identifier: GPL-3.0-or-later
// Plan of the assembly of P^T A P on a device, like that of a stiffness matrix from elements. A
// coarse element is the contribution of a few vertices between the same two nodes. One block of
// threads computes it, and every block of the matrix then gathers its parts from the elements.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/deform/step/assembly_plan.h"
#include "gpu/kernels/coarse_kernels.h"

namespace hepatica::gpu {

struct CoarseElements {
    std::vector<CoarseElement> element;
    std::vector<int> vertex;      // vertices of the elements
    std::vector<int> part_begin;  // first part of each pair of nodes, and the end of the last
    std::vector<int> part;        // indices of parts, see CoarseElement::part()
};

// `nodes`: the two nodes of each vertex. `pairs` must be distinct. A pair of nodes without common
// or neighbouring vertices receives no parts.
CoarseElements plan_coarse_elements(std::span<const std::array<int, 2>> nodes,
                                    const AssemblyPlan& plan, std::span<const NodePair> pairs);

}  // namespace hepatica::gpu
