// SPDX-License-Identifier: GPL-3.0-or-later
// Assembly of forces and stiffness by gathering: one thread per node, and one per upper block of
// the matrix, adds up the slots named in its list. No two threads write to the same place.
#pragma once

#include "gpu/kernels/element_kernels.h"
#include "gpu/kernels/planes.h"

namespace hepatica::gpu {

// Lists of slots in compressed form, as GatherLists.
struct ListsView {
    View<const int> begin, place;
    std::size_t bytes() const { return bytes_of(begin, place); }
};

// Sums the elastic force [uN] and energy [nJ] of each node.
struct GatherForces {
    ListsView lists;  // one list per node
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

// Sums the off-diagonal blocks of K: each upper block is written to its place, and transposed to
// its mirror.
template <class Real>
struct GatherStiffness {
    View<const int> place, mirror;          // indices of each upper block and its mirror in `block`
    ListsView factors, blocks, transposed;  // one list per upper block
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
