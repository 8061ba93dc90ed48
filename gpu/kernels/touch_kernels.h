// SPDX-License-Identifier: GPL-3.0-or-later
// Contacts on the device: points in the pad of a tool, pairs of surface features, Coulomb friction,
// and ties of parted joints, computed by the functions of core/deform/potentials that the CPU uses.
// One thread per touch computes its force; every node has a list of its touches, so that one thread
// per node adds up its force and matrix row, in the order of the lists.
#pragma once

#include "core/deform/potentials/pad_pair.h"
#include "core/deform/potentials/pad_point.h"
#include "core/deform/potentials/touch_list.h"
#include "gpu/kernels/element_kernels.h"

namespace hepatica::gpu {

// The effect of a touch on the weighted sum of its nodes' positions.
struct TouchPull {
    double weight[4];
    double energy;          // nJ
    Vector3<double> force;  // uN
    Vector3<double>
        turning[2];  // couples on two edges [uN]: minus at the beginning, plus at the end of each
    Matrix3<double> stiffness;  // uN/mm
    int active;                 // 0: no effect, and the other members are not set
};

// Positions by node number; numbers beyond `position` are points that do not move.
struct PlacesView {
    View<const Vector3<double>> position, standing;

    std::size_t bytes() const { return bytes_of(position, standing); }
    HEPATICA_HOST_DEVICE const Vector3<double>& operator[](int node) const {
        return node < position.size ? position[node] : standing[node - position.size];
    }
};

struct PressPoints {
    View<const PadPoint> point;
    View<const PadCapsule> tool;
    PlacesView place;
    View<TouchPull> pull;

    HEPATICA_HOST_DEVICE int count() const { return point.size; }
    std::size_t bytes() const {
        return bytes_of(point, tool, pull) + point.size * 3 * sizeof(Vector3<double>);
    }
    HEPATICA_HOST_DEVICE void operator()(int k) const {
        Vector3<double> corners[3];
        for (int a = 0; a < 3; ++a) corners[a] = place[point[k].nodes[a]];
        const PointPull is = pull_of(point[k], tool[point[k].part], corners);
        TouchPull& out = pull[k];
        out.active = is.pressed ? 1 : 0;
        if (!is.pressed) return;
        for (int a = 0; a < 3; ++a) out.weight[a] = point[k].weights[a];
        out.weight[3] = 0.0;
        out.energy = is.pad.energy_nj;
        out.force = is.pad.force_un * is.normal;
        out.turning[0] = out.turning[1] = {{0.0, 0.0, 0.0}};
        out.stiffness = small::outer(is.pad.stiffness_un_per_mm * is.normal, is.normal);
    }
};

struct PressPairs {
    View<const PadPair> pair;
    PlacesView place;
    View<TouchPull> pull;

    HEPATICA_HOST_DEVICE int count() const { return pair.size; }
    std::size_t bytes() const {
        return bytes_of(pair, pull) + pair.size * 4 * sizeof(Vector3<double>);
    }
    HEPATICA_HOST_DEVICE void operator()(int k) const {
        Vector3<double> corners[4];
        for (int a = 0; a < 4; ++a) corners[a] = place[pair[k].nodes[a]];
        const NearestPoints at = nearest_points(pair[k].in_first, corners);
        TouchPull& out = pull[k];
        out.active = at.gap_mm < pair[k].pad_mm ? 1 : 0;
        if (out.active == 0) return;
        const PairPull is = pull_of(pair[k], at, corners);
        for (int a = 0; a < 4; ++a) out.weight[a] = at.weights[a];
        out.energy = is.pad.energy_nj;
        out.force = is.pad.force_un * is.normal;
        out.turning[0] = is.turning_first_un;
        out.turning[1] = is.turning_second_un;
        out.stiffness = small::outer(is.pad.stiffness_un_per_mm * is.normal, is.normal);
    }
};

HEPATICA_HOST_DEVICE Vector3<double> slip_at(const RubPoint& rub, const PlacesView& place) {
    Vector3<double> moved{{0.0, 0.0, 0.0}};
    for (int a = 0; a < 4; ++a)
        if (rub.nodes[a] >= 0) moved = moved + rub.weights[a] * place[rub.nodes[a]];
    return slip_of(moved - rub.anchor, rub.normal);
}

// Computes energy and force of friction; ForeseeSlips computes its stiffness.
struct RubPoints {
    View<const RubPoint> rub;
    PlacesView place;
    View<TouchPull> pull;

    HEPATICA_HOST_DEVICE int count() const { return rub.size; }
    std::size_t bytes() const {
        return bytes_of(rub, pull) + rub.size * 4 * sizeof(Vector3<double>);
    }
    HEPATICA_HOST_DEVICE void operator()(int k) const {
        const Vector3<double> slip = slip_at(rub[k], place);
        TouchPull& out = pull[k];
        out.active = rub[k].law.limit_un > 0.0 ? 1 : 0;
        for (int a = 0; a < 4; ++a) out.weight[a] = rub[k].weights[a];
        out.energy = rub[k].law.energy_nj(slip);
        out.force = rub[k].law.force_un(slip);
        out.turning[0] = out.turning[1] = {{0.0, 0.0, 0.0}};
        out.stiffness = small::zero_matrix<double>();
    }
};

struct PullTies {
    SofteningLaw law;
    View<const TieTouch> tie;
    View<const Vector3<double>> position;
    View<TouchPull> pull;

    HEPATICA_HOST_DEVICE int count() const { return tie.size; }
    std::size_t bytes() const {
        return bytes_of(tie, pull) + tie.size * 2 * sizeof(Vector3<double>);
    }
    HEPATICA_HOST_DEVICE void operator()(int k) const {
        const Vector3<double> opening = position[tie[k].nodes[1]] - position[tie[k].nodes[0]];
        const TiePull is = pull_of(law, tie[k].corner, opening);
        TouchPull& out = pull[k];
        out.active = 1;
        out.weight[0] = 1.0;
        out.weight[1] = -1.0;
        out.weight[2] = out.weight[3] = 0.0;
        out.energy = is.energy_nj;
        out.force = is.force_un;
        out.turning[0] = out.turning[1] = {{0.0, 0.0, 0.0}};
        out.stiffness = is.stiffness_un_per_mm;
    }
};

// All touches by node: first those of pads, then friction, then ties.
struct TouchesView {
    View<const int> row;           // of every node; -1: it touches nothing; empty: nothing touches
    View<const int> begin, entry;  // list of each row: 4 t + a for node a of touch t
    View<const int> node;          // four per touch; -1: none, or one that does not move
    View<const TouchPull> pull;
    int first_rub = 0, first_tie = 0;

    std::size_t bytes() const { return bytes_of(row, begin, entry, node, pull); }

    // Calls visit(t, a) for every active touch of node i.
    template <class Visit>
    HEPATICA_HOST_DEVICE void for_each(int i, const Visit& visit) const {
        if (row.empty() || row[i] < 0) return;
        for (int k = begin[row[i]]; k < begin[row[i] + 1]; ++k)
            if (const int t = entry[k] / 4; pull[t].active != 0) visit(t, entry[k] % 4);
    }
    HEPATICA_HOST_DEVICE Vector3<double> force(int i) const {
        Vector3<double> sum{{0.0, 0.0, 0.0}};
        for_each(i, [&](int t, int a) {
            const TouchPull& is = pull[t];
            const double sign = a % 2 == 0 ? -1.0 : 1.0;
            sum = sum + (is.weight[a] * is.force + sign * is.turning[a / 2]);
        });
        return sum;
    }
    // Adds the energies of touches to one of the sums. The energy of a touch counts at the first of
    // its nodes that moves.
    HEPATICA_HOST_DEVICE void add_energy(int i, double& pads, double& friction,
                                         double& cohesion) const {
        for_each(i, [&](int t, int a) {
            for (int before = 0; before < a; ++before)
                if (node[4 * t + before] >= 0) return;
            (t < first_rub ? pads : (t < first_tie ? friction : cohesion)) += pull[t].energy;
        });
    }
    // Row i of the touches' stiffness times p.
    template <class Field>
    HEPATICA_HOST_DEVICE Vector3<double> product(int i, const Field& p) const {
        Vector3<double> sum{{0.0, 0.0, 0.0}};
        for_each(i, [&](int t, int a) {
            const TouchPull& is = pull[t];
            Vector3<double> moved{{0.0, 0.0, 0.0}};
            for (int b = 0; b < 4; ++b) {
                const int other = node[4 * t + b];
                if (other < 0) continue;
                const auto of_node = vector_of(p[other]);
                for (int c = 0; c < 3; ++c) moved[c] += is.weight[b] * double(of_node[c]);
            }
            sum = sum + is.weight[a] * (is.stiffness * moved);
        });
        return sum;
    }
    // The diagonal block of that row.
    HEPATICA_HOST_DEVICE Matrix3<double> diagonal(int i) const {
        Matrix3<double> sum = small::zero_matrix<double>();
        for_each(i, [&](int t, int a) {
            sum = sum + (pull[t].weight[a] * pull[t].weight[a]) * pull[t].stiffness;
        });
        return sum;
    }
};

// row[node[k]] = begin + k * step: sets the list of each node, or, with begin -1 and step 0,
// removes it.
struct SetRows {
    View<const int> node;
    int begin, step;
    View<int> row;

    HEPATICA_HOST_DEVICE int count() const { return node.size; }
    std::size_t bytes() const { return 2 * bytes_of(node); }
    HEPATICA_HOST_DEVICE void operator()(int k) const { row[node[k]] = begin + k * step; }
};

}  // namespace hepatica::gpu
