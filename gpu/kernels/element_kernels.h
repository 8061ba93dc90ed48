// SPDX-License-Identifier: GPL-3.0-or-later
// One thread an element: its forces and stiffness into slots of its own, laid out by the
// AssemblyPlan of core/deform, by the element functions that the CPU uses.
#pragma once

#include "core/deform/elements/spring_element.h"
#include "core/deform/elements/tetrahedron_element.h"
#include "gpu/kernels/view.h"

namespace hepatica::gpu {

using small::Matrix3;
using small::Vector3;

// What an element does to one of its nodes: a force [uN], and an equal share of its energy [nJ].
template <class Real>
struct ForceSlot {
    Vector3<Real> force;
    Real energy;
};

// The elements of one group, and where they are.
template <class Real>
struct GroupViews {
    View<const int> connectivity;
    View<const Vector3<double>> position;  // of every node, mm
    View<ForceSlot<Real>> slot;            // of every group
    int first_slot = 0;                    // of this group's

    std::size_t bytes() const {
        const std::size_t slots = static_cast<std::size_t>(connectivity.size);
        return bytes_of(connectivity, position) + slots * sizeof(ForceSlot<Real>);
    }
    // Positions relative to the first node, in double before they are rounded: a float has no
    // fewer digits of a strain far from the origin.
    template <int Nodes>
    HEPATICA_HOST_DEVICE void load(int e, Vector3<Real>* x) const {
        const Vector3<double>& origin = position[connectivity[Nodes * e]];
        for (int a = 0; a < Nodes; ++a) {
            const Vector3<double> d = position[connectivity[Nodes * e + a]] - origin;
            x[a] = {{Real(d[0]), Real(d[1]), Real(d[2])}};
        }
    }
    template <int Nodes>
    HEPATICA_HOST_DEVICE void store(int e, const Vector3<Real>* force, Real energy) const {
        for (int a = 0; a < Nodes; ++a)
            slot[first_slot + Nodes * e + a] = {force[a], energy / Real(Nodes)};
    }
};

// Linear corotated elements of one ratio lambda / mu: the stiffness in factors, see
// evaluate_turned_gradients.
template <class Real>
struct EvaluateTurned {
    GroupViews<Real> group;
    View<const small::TetrahedronRest<Real>> rest;
    View<Vector3<Real>> turned;  // as the slots

    HEPATICA_HOST_DEVICE int count() const { return rest.size; }
    std::size_t bytes() const { return group.bytes() + bytes_of(rest, turned); }
    HEPATICA_HOST_DEVICE void operator()(int e) const {
        Vector3<Real> x[4], force[4], gradient[4];
        group.template load<4>(e, x);
        const Real energy = small::evaluate_turned_gradients(rest[e], x, force, gradient);
        group.template store<4>(e, force, energy);
        for (int a = 0; a < 4; ++a) turned[group.first_slot + 4 * e + a] = gradient[a];
    }
};

// Tetrahedra of any law that write their blocks; without room for blocks, their forces alone.
template <class Real, int Nodes, small::Tangent tangent, template <class> class Law>
struct EvaluateTetrahedra {
    static constexpr int pairs = small::pair_count<Nodes>;

    GroupViews<Real> group;
    View<const small::TetrahedronRest<Real>> rest;
    View<Matrix3<Real>> block;  // of this group; may be empty

    HEPATICA_HOST_DEVICE int count() const { return rest.size; }
    std::size_t bytes() const { return group.bytes() + bytes_of(rest, block); }
    HEPATICA_HOST_DEVICE void operator()(int e) const {
        Vector3<Real> x[Nodes], force[Nodes];
        group.template load<Nodes>(e, x);
        Matrix3<Real>* const blocks = block.empty() ? nullptr : &block[pairs * e];
        const Real energy =
            blocks != nullptr
                ? small::evaluate_tetrahedron<Nodes, tangent, Law>(rest[e], x, force, blocks)
                : small::evaluate_tetrahedron<Nodes, small::Tangent::none, Law>(rest[e], x, force,
                                                                                blocks);
        group.template store<Nodes>(e, force, energy);
    }
};

template <class Real>
using EvaluateCorotated = EvaluateTetrahedra<Real, 4, small::Tangent::rotated, small::CorotatedLaw>;
template <class Real>
using EvaluateCorotated10 =
    EvaluateTetrahedra<Real, 10, small::Tangent::rotated, small::CorotatedLaw>;
template <class Real>
using EvaluateNeoHookean =
    EvaluateTetrahedra<Real, 4, small::Tangent::projected, small::NeoHookeanLaw>;

template <class Real>
struct EvaluateSprings {
    GroupViews<Real> group;
    View<const small::SpringRest<Real>> rest;
    View<Matrix3<Real>> block;  // of this group; may be empty

    HEPATICA_HOST_DEVICE int count() const { return rest.size; }
    std::size_t bytes() const { return group.bytes() + bytes_of(rest, block); }
    HEPATICA_HOST_DEVICE void operator()(int e) const {
        Vector3<Real> x[4], force[4];
        group.template load<4>(e, x);
        const Real energy =
            small::evaluate_springs(rest[e], x, force, block.empty() ? nullptr : &block[6 * e]);
        group.template store<4>(e, force, energy);
    }
};

}  // namespace hepatica::gpu
