// SPDX-License-Identifier: GPL-3.0-or-later
// The node-wise parts of a backward Euler step besides its linear system: positions and velocities,
// forces, energies and work, as in IncrementalPotential and StepBooks of core/deform. All in
// double.
#pragma once

#include "gpu/kernels/grab_kernels.h"
#include "gpu/kernels/sums.h"
#include "gpu/kernels/touch_kernels.h"

namespace hepatica::gpu {

// The state of the nodes and the forces on them besides those of elements. The step began at
// `start` with velocity `before` and is now at `position` with `velocity`.
struct NodeViews {
    View<const Vector3<double>> start, before, position, velocity, rest;
    View<const Vector3<double>> elastic_force;
    View<const double> elastic_energy;
    View<const double> mass, tether;
    View<const unsigned char> held;
    GrabsView grabs;
    TouchesView touches;
    Vector3<double> gravity;

    std::size_t bytes() const {
        return bytes_of(start, before, position, velocity, rest, elastic_force, elastic_energy,
                        mass, tether, held) +
               grabs.bytes() + touches.bytes();
    }
    // Elastic force plus that of the potentials [uN].
    HEPATICA_HOST_DEVICE Vector3<double> force(int i) const {
        return elastic_force[i] + mass[i] * gravity + tether[i] * (rest[i] - position[i]) +
               grabs.force(i) + touches.force(i);
    }
};

// w = share v_n + change, x = x_n + dt w. Held nodes have v_n = 0 and no change.
struct PlaceNodes {
    View<const Vector3<double>> start, before;
    View<const Vector3<double>> change;  // empty: none
    double share, dt;
    View<Vector3<double>> position, velocity;

    HEPATICA_HOST_DEVICE int count() const { return position.size; }
    std::size_t bytes() const { return bytes_of(start, before, change, position, velocity); }
    HEPATICA_HOST_DEVICE void operator()(int i) const {
        Vector3<double> w = share * before[i];
        if (!change.empty()) w = w + change[i];
        velocity[i] = w;
        position[i] = start[i] + dt * w;
    }
};

// Minus dt times the gradient of the incremental potential:
//   M (v_n - (1 + dt alpha) w) + dt f(x) - dt damping; zero where a node is held.
struct Descent {
    NodeViews nodes;
    View<const Vector3<double>> damping;  // beta K_0 w; empty: none
    double dt, inertia;                   // 1 + dt alpha
    View<Vector3<double>> descent;

    HEPATICA_HOST_DEVICE int count() const { return descent.size; }
    std::size_t bytes() const { return nodes.bytes() + bytes_of(damping, descent); }
    HEPATICA_HOST_DEVICE Vector3<double> at(int i) const {
        if (nodes.held[i] != 0) return {{0.0, 0.0, 0.0}};
        Vector3<double> r =
            nodes.mass[i] * (nodes.before[i] - inertia * nodes.velocity[i]) + dt * nodes.force(i);
        if (!damping.empty()) r = r - dt * damping[i];
        return r;
    }
    HEPATICA_HOST_DEVICE void operator()(int i) const { descent[i] = at(i); }
};

// a -= b
struct Subtract {
    View<Vector3<double>> a;
    View<const Vector3<double>> b;

    HEPATICA_HOST_DEVICE int count() const { return a.size; }
    std::size_t bytes() const { return bytes_of(a, a, b); }
    HEPATICA_HOST_DEVICE void operator()(int i) const { a[i] = a[i] - b[i]; }
};

// Computes the stiffness of friction. A slipping contact is about to stick where the other forces
// on it fall short of friction, as in CoulombFriction::foresee(). Touch first_rub + k is rub k.
struct ForeseeSlips {
    NodeViews nodes;
    View<const RubPoint> rub;
    PlacesView place;
    View<TouchPull> pull;  // of rubs

    HEPATICA_HOST_DEVICE int count() const { return rub.size; }
    std::size_t bytes() const { return nodes.bytes() + bytes_of(rub, pull); }
    // The friction limit of this kind of contact on a node [uN].
    HEPATICA_HOST_DEVICE double limit_of(int node, int kind) const {
        double limit = 0.0;
        nodes.touches.for_each(node, [&](int t, int a) {
            const int other = t - nodes.touches.first_rub;
            if (other >= 0 && t < nodes.touches.first_tie && rub[other].kind == kind)
                limit += small::detail::absolute(rub[other].weights[a]) * rub[other].law.limit_un;
        });
        return limit;
    }
    HEPATICA_HOST_DEVICE void operator()(int k) const {
        const Vector3<double> slip = slip_at(rub[k], place);
        double pressing = 0.0;
        for (int a = 0; a < 4; ++a) {
            const int node = rub[k].nodes[a];
            const double limit = node >= 0 ? limit_of(node, rub[k].kind) : 0.0;
            if (limit > 0.0)
                pressing += rub[k].weights[a] * small::dot(nodes.force(node), slip) / limit;
        }
        const bool slows =
            pressing < -slowing_share * small::detail::root(small::squared_length(slip));
        pull[k].stiffness = rub[k].law.stiffness_un_per_mm(slip, rub[k].normal, slows);
    }
};

// Stores the forces at the start of a step, for the work along it.
struct KeepForces {
    NodeViews nodes;
    View<Vector3<double>> force;

    HEPATICA_HOST_DEVICE int count() const { return force.size; }
    std::size_t bytes() const { return nodes.bytes() + bytes_of(force); }
    HEPATICA_HOST_DEVICE void operator()(int i) const { force[i] = nodes.force(i); }
};

// Energies [nJ]: kinetic, elastic, of grabs, of the tether, minus the work of gravity since x_n, |w
// - v_n|_M^2 / 2, of contact pads, dissipated by friction, and of ties between parted joints.
struct Energies {
    static constexpr int width = 9;
    enum { kinetic, elastic, grab, tether, weight, inertial, contact, friction, cohesion };
    NodeViews nodes;

    std::size_t bytes() const { return nodes.bytes(); }
    HEPATICA_HOST_DEVICE void operator()(int i, double* sum) const {
        const Vector3<double> w = nodes.velocity[i], x = nodes.position[i];
        const Vector3<double> dw = w - nodes.before[i], off = x - nodes.rest[i];
        sum[kinetic] += 0.5 * nodes.mass[i] * small::dot(w, w);
        sum[elastic] += nodes.elastic_energy[i];
        sum[grab] += nodes.grabs.energy(i);
        sum[tether] += 0.5 * nodes.tether[i] * small::dot(off, off);
        sum[weight] -= nodes.mass[i] * small::dot(nodes.gravity, x - nodes.start[i]);
        sum[inertial] += 0.5 * nodes.mass[i] * small::dot(dw, dw);
        nodes.touches.add_energy(i, sum[contact], sum[friction], sum[cohesion]);
    }
};

// With the direction taken, d = change + share v_n, sums steepest . d and residual . d.
struct AlongDirection {
    static constexpr int width = 2;
    View<const Vector3<double>> steepest, residual, change;
    View<const Vector3<double>> before;
    double share;

    std::size_t bytes() const { return bytes_of(steepest, residual, change, before); }
    HEPATICA_HOST_DEVICE void operator()(int i, double* sum) const {
        const Vector3<double> d = change[i] + share * before[i];
        sum[0] += small::dot(steepest[i], d);
        sum[1] += small::dot(residual[i], d);
    }
};

// Sums the work along the motion dt w of the forces at the start and at the end, and w . descent.
struct Works {
    static constexpr int width = 3;
    Descent end;
    View<const Vector3<double>> start_force;

    std::size_t bytes() const { return end.bytes() + bytes_of(start_force); }
    HEPATICA_HOST_DEVICE void operator()(int i, double* sum) const {
        const Vector3<double> w = end.nodes.velocity[i];
        sum[0] += end.dt * small::dot(w, start_force[i]);
        sum[1] += end.dt * small::dot(w, end.nodes.force(i));
        sum[2] += small::dot(w, end.at(i));
    }
};

}  // namespace hepatica::gpu
