// SPDX-License-Identifier: GPL-3.0-or-later
// One thread per element: its forces and stiffness are written to slots of its own, laid out by the
// AssemblyPlan of core/deform and computed by the element functions that the CPU uses. All is
// computed in double, and only the stiffness is rounded to Real: forces rounded to float would hide
// slow motion beside stiff elements.
#pragma once

#include "core/deform/elements/spring_element.h"
#include "core/deform/elements/tetrahedron_element.h"
#include "gpu/kernels/planes.h"

namespace hepatica::gpu {

using small::Matrix3;
using small::Vector3;

// Three numbers, padded so that a device moves four at once.
template <class T>
struct alignas(4 * sizeof(T)) Aligned3 : Vector3<T> {
    Aligned3() = default;
    HEPATICA_HOST_DEVICE Aligned3(const Vector3<T>& value) : Vector3<T>(value), unused(T(0)) {}

  private:
    T unused;
};
static_assert(sizeof(Aligned3<float>) == 4 * sizeof(float));

// The force of an element on one of its nodes [uN], and an equal share of its energy [nJ].
struct alignas(16) ForceSlot {
    Vector3<double> force;
    double energy;
};

using TetrahedronRests = Planes<small::TetrahedronRest<double>, const double>;

template <class Real>
HEPATICA_HOST_DEVICE Vector3<Real> rounded(const Vector3<double>& v) {
    return {{Real(v[0]), Real(v[1]), Real(v[2])}};
}
template <class Real>
HEPATICA_HOST_DEVICE void round_to(const Matrix3<double>& from, Matrix3<Real>& to) {
    for (int r = 0; r < 3; ++r)
        for (int c = 0; c < 3; ++c) to(r, c) = Real(from(r, c));
}

// The elements of one group and the positions of the nodes.
struct GroupViews {
    View<const int> connectivity;
    View<const Vector3<double>> position;  // of every node [mm]
    View<ForceSlot> slot;                  // of all groups
    int first_slot = 0;                    // first slot of this group

    std::size_t bytes() const {
        const std::size_t slots = static_cast<std::size_t>(connectivity.size);
        return bytes_of(connectivity, position) + slots * sizeof(ForceSlot);
    }
    template <int Nodes>
    HEPATICA_HOST_DEVICE void load(int e, Vector3<double>* x) const {
        for (int a = 0; a < Nodes; ++a) x[a] = position[connectivity[Nodes * e + a]];
    }
    template <int Nodes>
    HEPATICA_HOST_DEVICE void store(int e, const Vector3<double>* force, double energy) const {
        for (int a = 0; a < Nodes; ++a)
            slot[first_slot + Nodes * e + a] = {force[a], energy / Nodes};
    }
};

// Linear corotated elements with one ratio lambda / mu; their stiffness is stored in factors, see
// evaluate_turned_gradients().
template <class Real>
struct EvaluateTurned {
    GroupViews group;
    TetrahedronRests rest;
    View<Aligned3<Real>> turned;  // laid out as the slots

    HEPATICA_HOST_DEVICE int count() const { return rest.size; }
    std::size_t bytes() const { return group.bytes() + bytes_of(rest) + bytes_of(turned); }
    HEPATICA_HOST_DEVICE void operator()(int e) const {
        Vector3<double> x[4], force[4], gradient[4];
        group.load<4>(e, x);
        const double energy = small::evaluate_turned_gradients(rest[e], x, force, gradient);
        group.store<4>(e, force, energy);
        for (int a = 0; a < 4; ++a)
            turned[group.first_slot + 4 * e + a] = Aligned3<Real>(rounded<Real>(gradient[a]));
    }
};

// Tetrahedra of any law that write their stiffness blocks; without room for blocks, the forces
// alone.
template <class Real, int Nodes, small::Tangent tangent, template <class> class Law>
struct EvaluateTetrahedra {
    static constexpr int pairs = small::pair_count<Nodes>;

    GroupViews group;
    TetrahedronRests rest;
    View<Matrix3<Real>> block;  // of this group; may be empty

    HEPATICA_HOST_DEVICE int count() const { return rest.size; }
    std::size_t bytes() const { return group.bytes() + bytes_of(rest) + bytes_of(block); }
    HEPATICA_HOST_DEVICE void operator()(int e) const {
        Vector3<double> x[Nodes], force[Nodes];
        group.load<Nodes>(e, x);
        if (block.empty()) {
            Matrix3<double>* const none = nullptr;
            const double energy = small::evaluate_tetrahedron<Nodes, small::Tangent::none, Law>(
                rest[e], x, force, none);
            return group.store<Nodes>(e, force, energy);
        }
        Matrix3<double> blocks[pairs];
        group.store<Nodes>(
            e, force, small::evaluate_tetrahedron<Nodes, tangent, Law>(rest[e], x, force, blocks));
        for (int p = 0; p < pairs; ++p) round_to(blocks[p], block[pairs * e + p]);
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
    GroupViews group;
    View<const small::SpringRest<double>> rest;
    View<Matrix3<Real>> block;  // of this group; may be empty

    HEPATICA_HOST_DEVICE int count() const { return rest.size; }
    std::size_t bytes() const { return group.bytes() + bytes_of(rest, block); }
    HEPATICA_HOST_DEVICE void operator()(int e) const {
        Vector3<double> x[4], force[4];
        Matrix3<double> blocks[6];
        group.load<4>(e, x);
        group.store<4>(
            e, force, small::evaluate_springs(rest[e], x, force, block.empty() ? nullptr : blocks));
        for (int p = 0; p < 6 && !block.empty(); ++p) round_to(blocks[p], block[6 * e + p]);
    }
};

}  // namespace hepatica::gpu
