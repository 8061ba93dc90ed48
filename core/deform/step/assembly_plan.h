// SPDX-License-Identifier: GPL-3.0-or-later
// Where every element of a body writes its forces and stiffness, and where every node and every
// nonzero block of the matrix gathers them from, as plain arrays. Made once from the body and
// independent of the back end, so that host and device gather alike.
#pragma once

#include <cstddef>
#include <vector>

#include "core/deform/body/body.h"
#include "core/deform/elements/tetrahedron_element.h"

namespace hepatica {

// Slots of one element group. Node a of element e writes its force into first_force + e *
// nodes_per_element + a, pair k its block into first_block + e * pairs + k.
struct GroupSlots {
    bool four_at_a_time = false;  // in SIMD lanes: corotated law, rotated stiffness
    bool in_factors = false;      // writes turned gradients instead of stiffness blocks
    std::size_t first_force = 0;
    std::size_t first_block = 0;
};

// Lists of slots: entry k has place[begin[k]] ... place[begin[k + 1] - 1].
struct GatherLists {
    std::vector<int> begin{0};
    std::vector<int> place;
};

struct AssemblyPlan {
    // Slots.
    std::vector<GroupSlots> groups;  // as the body's
    int force_slots = 0;
    int block_slots = 0;
    double lambda_over_mu = 0.0;  // of all groups with in_factors

    // Nonzero blocks of the matrix, as in BlockMatrix.
    std::vector<int> row_begin{0};
    std::vector<int> column;
    std::vector<int> diagonal;
    std::vector<int> mirror;  // index of block (j, i) for every block (i, j)

    GatherLists forces;      // per node: force slots
    GatherLists factors;     // per upper block: pairs of turned gradients (row, column)
    GatherLists blocks;      // per upper block: block slots to be added
    GatherLists transposed;  // per upper block: block slots to be added transposed

    int force_slot(std::size_t group, int element, int nodes_per_element) const {
        return static_cast<int>(groups[group].first_force) + element * nodes_per_element;
    }
    int block_slot(std::size_t group, int element, int pairs) const {
        return static_cast<int>(groups[group].first_block) + element * pairs;
    }
};

// `tangent` is the stiffness that is written, not Tangent::none. Throws InputError for a body with
// more slots than an int can count. Costs one pass over the elements of every node.
AssemblyPlan plan_assembly(const Body& body, small::Tangent tangent);

// The plan_assembly() of a body whose nodes were split, or merged again, since `plan` was made for
// `before`: the same elements at other nodes. Rows of nodes with unchanged elements and partners
// are copied.
AssemblyPlan plan_after_split(const AssemblyPlan& plan, const Body& before, const Body& body);

// The connected component of each node: nodes that share an element are in the same one. Numbered
// from 0 in the order of their first nodes.
std::vector<int> connected_pieces(const AssemblyPlan& plan);

}  // namespace hepatica
