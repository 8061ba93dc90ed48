// SPDX-License-Identifier: GPL-3.0-or-later
// Where every element of a body writes its forces and stiffness, and from where every node and
// every nonzero block of the matrix gathers them, as plain arrays: made once from the body, with no
// code of a back end in it, so that host and device can gather alike.
#pragma once

#include <cstddef>
#include <vector>

#include "core/deform/body/body.h"
#include "core/deform/elements/tetrahedron_element.h"

namespace hepatica {

// Slots of one element group. Node a of element e writes its force into
// first_force + e * nodes_per_element + a, pair k its block into first_block + e * pairs + k.
struct GroupSlots {
    bool four_at_a_time = false;  // evaluated in lanes: corotated, with the rotated stiffness
    bool in_factors = false;      // writes turned gradients, beside its forces, in place of blocks
    std::size_t first_force = 0;
    std::size_t first_block = 0;
};

// Lists over slots: that of entry k is place[begin[k]] ... place[begin[k + 1] - 1].
struct GatherLists {
    std::vector<int> begin{0};
    std::vector<int> place;
};

struct AssemblyPlan {
    // Slots.
    std::vector<GroupSlots> groups;  // as the body's
    int force_slots = 0;
    int block_slots = 0;
    double lambda_over_mu = 0.0;  // of all groups in factors

    // Nonzero blocks of the matrix, as in BlockMatrix.
    std::vector<int> row_begin{0};
    std::vector<int> column;
    std::vector<int> diagonal;
    std::vector<int> mirror;  // position of block (j, i) for every block (i, j)

    // What is added up.
    GatherLists forces;      // of each node: force slots
    GatherLists factors;     // of each upper block: two turned gradients, of its row and its column
    GatherLists blocks;      // of each upper block: block slots as they were written,
    GatherLists transposed;  // and to be transposed

    int force_slot(std::size_t group, int element, int nodes_per_element) const {
        return static_cast<int>(groups[group].first_force) + element * nodes_per_element;
    }
    int block_slot(std::size_t group, int element, int pairs) const {
        return static_cast<int>(groups[group].first_block) + element * pairs;
    }
};

// `tangent` is the stiffness that is written, not Tangent::none. Throws InputError for a body of
// more slots than an int can count. Costs one pass over the elements of every node.
AssemblyPlan plan_assembly(const Body& body, small::Tangent tangent);

// What plan_assembly() would make of a body whose nodes were split, or mended, since `plan` was
// made of it as it was `before`: the same elements at other nodes. Rows of nodes whose elements and
// partners are those they were are taken over.
AssemblyPlan plan_after_split(const AssemblyPlan& plan, const Body& before, const Body& body);

// The piece of each node, counted from 0 in the order of their first nodes: nodes that share an
// element are of one piece.
std::vector<int> connected_pieces(const AssemblyPlan& plan);

}  // namespace hepatica
