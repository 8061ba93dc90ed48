// SPDX-License-Identifier: GPL-3.0-or-later
// Two features of surfaces, a vertex and a triangle or two edges, with a pad between them: the
// equations of surface_pairs.h, for host and device.
#pragma once

#include "core/contact/closest_features.h"
#include "core/deform/potentials/pad_barrier.h"

namespace hepatica {

constexpr double nearly_parallel = 0.01;  // sin^2 of the angle between edges

struct PadPair {
    int nodes[4];  // of the first feature, then of the second
    int in_first;  // nodes of the first feature: 1 (vertex and triangle) or 2 (two edges)
    double pad_mm, strength_un;
    double parallel_mm4;  // two edges: nearly_parallel times their squared rest lengths
};

// The nearest points of two features, as weights of their corners.
struct NearestPoints {
    double weights[4];             // > 0 on the first feature, < 0 on the second
    small::Vector3<double> apart;  // from the second point to the first
    double gap_mm;
};

struct PairPull {
    small::Vector3<double> normal;  // from the second to the first, of length 1
    PadBarrier pad;                 // its force is along the normal on the first
    // Nearly parallel edges: forces on their ends, minus this at the first end, plus at the second.
    small::Vector3<double> turning_first_un, turning_second_un;
};

HEPATICA_HOST_DEVICE NearestPoints nearest_points(int in_first, const small::Vector3<double>* x) {
    NearestPoints at{};
    if (in_first == 2) {
        const small::OnSegments on = small::closest_on_segments(x, x + 2);
        at.weights[0] = 1.0 - on.along_first;
        at.weights[1] = on.along_first;
        at.weights[2] = on.along_second - 1.0;
        at.weights[3] = -on.along_second;
    } else {
        const small::OnTriangle on = small::closest_on_triangle(x[0], x + 1);
        at.weights[0] = 1.0;
        for (int a = 0; a < 3; ++a) at.weights[a + 1] = -on.weights[a];
    }
    for (int a = 0; a < 4; ++a) at.apart = at.apart + at.weights[a] * x[a];
    at.gap_mm = std::sqrt(small::squared_length(at.apart));
    return at;
}

// Fades the pad out where two edges are nearly parallel.
HEPATICA_HOST_DEVICE void fade(const PadPair& pair, const small::Vector3<double>* x,
                               PairPull& pull) {
    const small::Vector3<double> e = x[1] - x[0], f = x[3] - x[2];
    const double full = pair.parallel_mm4;
    const double c = small::squared_length(small::cross(e, f)) / full;
    if (c >= 1.0) return;
    const double share = c * (2.0 - c);
    // -energy times the gradient of `share` with respect to the edge vectors e and f.
    const double slope = -pull.pad.energy_nj * 2.0 * (1.0 - c) * 2.0 / full;
    const double ee = small::squared_length(e), ff = small::squared_length(f);
    const double ef = small::dot(e, f);
    pull.turning_first_un = slope * (ff * e - ef * f);
    pull.turning_second_un = slope * (ee * f - ef * e);
    pull.pad.energy_nj *= share;
    pull.pad.force_un *= share;
    pull.pad.stiffness_un_per_mm *= share;
}

// Requires a gap smaller than the pad.
HEPATICA_HOST_DEVICE PairPull pull_of(const PadPair& pair, const NearestPoints& at,
                                      const small::Vector3<double>* x) {
    PairPull pull{};
    pull.normal = {{0.0, 0.0, 1.0}};
    for (int c = 0; c < 3 && at.gap_mm > 0.0; ++c) pull.normal[c] = at.apart[c] / at.gap_mm;
    pull.pad = pad_barrier(at.gap_mm, pair.pad_mm, pair.strength_un);
    if (pair.in_first == 2 && at.gap_mm > 0.0) fade(pair, x, pull);
    return pull;
}

}  // namespace hepatica
