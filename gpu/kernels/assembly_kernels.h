// SPDX-License-Identifier: GPL-3.0-or-later
// Assembly by nonzero entries in global memory: one thread a node, and one a nonzero block, adds up
// the slots that its list names. No two threads write one place.
#pragma once

#include "gpu/kernels/element_kernels.h"
#include "gpu/kernels/planes.h"

namespace hepatica::gpu {

// Lists over slots, as GatherLists.
struct ListsView {
    View<const int> begin, place;
    std::size_t bytes() const { return bytes_of(begin, place); }
};

// Elastic force and energy of each node.
struct GatherForces {
    ListsView lists;  // one a node
    View<const ForceSlot> slot;
    View<Vector3<double>> force;
    View<double> energy;

    HEPATICA_HOST_DEVICE int count() const { return force.size; }
    std::size_t bytes() const { return lists.bytes() + bytes_of(slot, force, energy); }
    HEPATICA_HOST_DEVICE void operator()(int i) const {
        Vector3<double> sum{{0.0, 0.0, 0.0}};
        double stored = 0.0;
        for (int k = lists.begin[i]; k < lists.begin[i + 1]; ++k) {
            const ForceSlot& share = slot[lists.place[k]];
            sum = sum + share.force;
            stored += share.energy;
        }
        force[i] = sum;
        energy[i] = stored;
    }
};

// The blocks of K beside the diagonal: each upper one is added up and written to its two places.
template <class Real>
struct GatherStiffness {
    View<const int> place, mirror;          // of each upper block in `block`
    ListsView factors, blocks, transposed;  // one list an upper block
    View<const Aligned3<Real>> turned;
    View<const Matrix3<Real>> slot;
    Real lambda_over_mu;
    Planes<Matrix3<Real>, Real> block;

    HEPATICA_HOST_DEVICE int count() const { return place.size; }
    std::size_t bytes() const {
        return factors.bytes() + blocks.bytes() + transposed.bytes() +
               bytes_of(place, mirror, turned, slot) + bytes_of(block);
    }
    HEPATICA_HOST_DEVICE void operator()(int u) const {
        Matrix3<Real> s = small::zero_matrix<Real>();
        for (int k = factors.begin[u]; k < factors.begin[u + 1]; k += 2)
            s = s + small::outer<Real>(turned[factors.place[k + 1]], turned[factors.place[k]]);
        const Matrix3<Real> swapped = small::transpose(s);
        Matrix3<Real> sum = s + lambda_over_mu * swapped;
        const Real trace = small::trace(s);
        for (int i = 0; i < 3; ++i) sum(i, i) += trace;
        for (int k = blocks.begin[u]; k < blocks.begin[u + 1]; ++k)
            sum = sum + slot[blocks.place[k]];
        for (int k = transposed.begin[u]; k < transposed.begin[u + 1]; ++k)
            sum = sum + small::transpose(slot[transposed.place[k]]);
        block.set(place[u], sum);
        block.set(mirror[u], small::transpose(sum));
    }
};

}  // namespace hepatica::gpu
