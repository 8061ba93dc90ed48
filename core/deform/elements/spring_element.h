// SPDX-License-Identifier: GPL-3.0-or-later
// The cheapest tetrahedron: six springs along its edges and one that resists a change of volume,
// for host and device. Averaged over all directions, springs with the energy density kappa/2 sum (n
// . strain n)^2 make a solid with lambda = mu = 2/5 kappa; the volume spring adds the rest of
// lambda. Where Poisson's ratio is below 1/4 this rest would be negative, and there is no volume
// spring.
#pragma once

#include "core/deform/elements/tetrahedron_element.h"

namespace hepatica::small {

template <class T>
struct SpringRest {
    T length[6];     // mm, edges (0,1) (0,2) (0,3) (1,2) (1,3) (2,3)
    T stiffness[6];  // uN/mm
    T volume;        // mm3
    T bulk;          // Pa, of the volume spring
};

HEPATICA_HOST_DEVICE void spring_corners(int pair, int& a, int& b) {
    constexpr int first[6] = {0, 0, 0, 1, 1, 2}, second[6] = {1, 2, 3, 2, 3, 3};
    a = first[pair];
    b = second[pair];
}

template <class T>
HEPATICA_HOST_DEVICE SpringRest<T> spring_rest(const Vector3<T>* x, T lambda, T mu) {
    SpringRest<T> rest;
    rest.volume = dot(cross(x[1] - x[0], x[2] - x[0]), x[3] - x[0]) / T(6);
    rest.bulk = detail::larger(lambda - mu, T(0));
    for (int e = 0; e < 6; ++e) {
        int a = 0, b = 0;
        spring_corners(e, a, b);
        const Vector3<T> d = x[b] - x[a];
        rest.length[e] = detail::root(dot(d, d));
        rest.stiffness[e] = T(2.5) * mu * rest.volume / dot(d, d);
    }
    return rest;
}

// As evaluate_tetrahedron. The stiffness leaves out the terms that may be negative: the transverse
// part of a compressed spring and the second derivative of the volume.
template <class T>
HEPATICA_HOST_DEVICE T evaluate_springs(const SpringRest<T>& rest, const Vector3<T>* x,
                                        Vector3<T>* force, Matrix3<T>* blocks) {
    if (force)
        for (int a = 0; a < 4; ++a) force[a] = {{T(0), T(0), T(0)}};
    T energy = T(0);
    for (int e = 0; e < 6; ++e) {
        int a = 0, b = 0;
        spring_corners(e, a, b);
        const Vector3<T> d = x[b] - x[a];
        const T length = detail::root(dot(d, d)), stretch = length - rest.length[e];
        const T k = rest.stiffness[e];
        energy += T(0.5) * k * stretch * stretch;
        // A spring of zero length has no direction and exerts no force.
        const bool collapsed = !(length > T(1e-6) * rest.length[e]);
        const Vector3<T> n = collapsed ? Vector3<T>{{T(0), T(0), T(0)}} : (T(1) / length) * d;
        if (force) {
            const Vector3<T> pull = (k * stretch) * n;
            force[a] = force[a] + pull;
            force[b] = force[b] - pull;
        }
        if (blocks) {
            const T side = collapsed ? k : k * detail::larger(T(0), stretch / length);
            blocks[e] = (side - k) * outer(n, n) - side * identity_matrix<T>();
        }
    }
    Vector3<T> gradient[4];  // of the volume
    const Vector3<T> p = x[1] - x[0], q = x[2] - x[0], r = x[3] - x[0];
    gradient[1] = (T(1) / T(6)) * cross(q, r);
    gradient[2] = (T(1) / T(6)) * cross(r, p);
    gradient[3] = (T(1) / T(6)) * cross(p, q);
    gradient[0] = T(-1) * (gradient[1] + gradient[2] + gradient[3]);
    const T swell = dot(cross(p, q), r) / (T(6) * rest.volume) - T(1);
    energy += T(0.5) * rest.bulk * rest.volume * swell * swell;
    if (force)
        for (int a = 0; a < 4; ++a) force[a] = force[a] - (rest.bulk * swell) * gradient[a];
    if (blocks)
        for (int e = 0; e < 6; ++e) {
            int a = 0, b = 0;
            spring_corners(e, a, b);
            blocks[e] = blocks[e] + (rest.bulk / rest.volume) * outer(gradient[a], gradient[b]);
        }
    return energy;
}

}  // namespace hepatica::small
