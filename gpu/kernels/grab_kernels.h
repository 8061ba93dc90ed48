// SPDX-License-Identifier: GPL-3.0-or-later
// Grabs on the device, with the equations of GrabSprings: a spring of limited force between a
// target and a weighted mean of up to four nodes. Every node has a list of its grabs, so that one
// thread per node computes its matrix row and its force.
#pragma once

#include "gpu/kernels/element_kernels.h"
#include "gpu/kernels/quads.h"

namespace hepatica::gpu {

struct GrabSpring {
    int node[4];  // -1: none
    double weight[4];
    Vector3<double> target;
    double stiffness, limit;  // uN/mm, uN
    // Bit 4 a + b: the elements' matrix has a block for nodes a and b. Without one, the pair's
    // stiffness is added to the diagonal, as in GrabSprings.
    unsigned stored;
};

struct GrabPull {
    double energy;
    Vector3<double> force;      // on the held point [uN]
    Matrix3<double> stiffness;  // uN/mm
};

// Computes force, energy and stiffness of each grab; one thread per grab.
struct PullGrabs {
    View<const GrabSpring> grab;
    View<const Vector3<double>> position;
    View<GrabPull> pull;

    HEPATICA_HOST_DEVICE int count() const { return grab.size; }
    std::size_t bytes() const { return bytes_of(grab, pull); }
    HEPATICA_HOST_DEVICE void operator()(int g) const {
        const GrabSpring& spring = grab[g];
        Vector3<double> stretch{{0.0, 0.0, 0.0}};
        for (int a = 0; a < 4; ++a)
            if (spring.node[a] >= 0)
                stretch = stretch + spring.weight[a] * (spring.target - position[spring.node[a]]);
        const double length = small::detail::root(small::dot(stretch, stretch));
        const double end = spring.limit / spring.stiffness;
        const Matrix3<double> one = small::identity_matrix<double>();
        if (length <= end) {
            pull[g] = {0.5 * spring.stiffness * length * length, spring.stiffness * stretch,
                       spring.stiffness * one};
            return;
        }
        const double steady = spring.limit / length;
        const Vector3<double> n = (1.0 / length) * stretch;
        pull[g] = {spring.limit * (length - 0.5 * end), steady * stretch,
                   steady * (one - small::outer(n, n))};
    }
};

// All grabs by node, as linked lists: entries first[i], next[first[i]], ... are 4 g + a for node a
// of grab g.
struct GrabsView {
    View<const int> first, next;
    View<const GrabSpring> grab;
    View<const GrabPull> pull;

    std::size_t bytes() const { return bytes_of(first); }

    // Calls visit(g, a) for every grab that holds node i.
    template <class Visit>
    HEPATICA_HOST_DEVICE void for_each(int i, const Visit& visit) const {
        if (first.empty()) return;
        for (int entry = first[i]; entry >= 0; entry = next[entry]) visit(entry / 4, entry % 4);
    }
    HEPATICA_HOST_DEVICE Vector3<double> force(int i) const {
        Vector3<double> sum{{0.0, 0.0, 0.0}};
        for_each(i, [&](int g, int a) { sum = sum + grab[g].weight[a] * pull[g].force; });
        return sum;
    }
    // The energy of a grab counts at its first node.
    HEPATICA_HOST_DEVICE double energy(int i) const {
        double sum = 0.0;
        for_each(i, [&](int g, int a) { sum += a == 0 ? pull[g].energy : 0.0; });
        return sum;
    }
    // Row i of the grabs' stiffness times p.
    template <class Field>
    HEPATICA_HOST_DEVICE Vector3<double> product(int i, const Field& p) const {
        Vector3<double> sum{{0.0, 0.0, 0.0}};
        for_each(i, [&](int g, int a) {
            const GrabSpring& spring = grab[g];
            for (int b = 0; b < 4; ++b) {
                if (spring.node[b] < 0) continue;
                const bool stored = (spring.stored >> (4 * a + b) & 1u) != 0;
                const double both = spring.weight[a] * spring.weight[b];
                const auto moved = vector_of(p[stored ? spring.node[b] : i]);
                const Vector3<double> d{{double(moved[0]), double(moved[1]), double(moved[2])}};
                sum =
                    sum + (stored ? both : small::detail::absolute(both)) * (pull[g].stiffness * d);
            }
        });
        return sum;
    }
    // The diagonal block of that row.
    HEPATICA_HOST_DEVICE Matrix3<double> diagonal(int i) const {
        Matrix3<double> sum = small::zero_matrix<double>();
        for_each(i, [&](int g, int a) {
            const GrabSpring& spring = grab[g];
            for (int b = 0; b < 4; ++b) {
                if (spring.node[b] < 0) continue;
                const bool stored = (spring.stored >> (4 * a + b) & 1u) != 0;
                const double both = spring.weight[a] * spring.weight[b];
                if (stored && spring.node[b] != i) continue;
                sum = sum + (stored ? both : small::detail::absolute(both)) * pull[g].stiffness;
            }
        });
        return sum;
    }
};

}  // namespace hepatica::gpu
