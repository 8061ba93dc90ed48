// SPDX-License-Identifier: GPL-3.0-or-later
// Tetrahedra of 4 and 10 nodes for any constitutive law: energy, force and stiffness, for host and
// device. The linear element has one integration point, the quadratic one four and straight edges
// at rest. In the quadratic element the part of lambda above 4 mu (nu = 0.4) acts on the mean
// dilatation, so that it does not lock near nu = 1/2; for smaller lambda it is the usual element.
#pragma once

#include "core/deform/elements/constitutive_law.h"

namespace hepatica::small {

// An element's shape and material at rest.
template <class T>
struct TetrahedronRest {
    Vector3<T> gradient[3];  // of the barycentric coordinates of corners 1, 2, 3; 1/mm
    T volume;                // mm3
    T lambda;                // Lame, Pa
    T mu;
};

// `rotated`: the linear stiffness in the rotated frame (corotated law only; positive semidefinite
// by construction; the published step). `projected`: the exact Hessian without its negative
// eigenvalues (Newton's method).
enum class Tangent { none, rotated, projected };

// Number of pairs of nodes a < b; the block of pair (a, b) is at pair_index(a, b).
template <int Nodes>
inline constexpr int pair_count = Nodes*(Nodes - 1) / 2;
template <int Nodes>
HEPATICA_HOST_DEVICE constexpr int pair_index(int a, int b) {
    return a * Nodes - a * (a + 1) / 2 + b - a - 1;
}

// Corners of the mid-edge nodes 4..9, in VTK's order.
HEPATICA_HOST_DEVICE void edge_corners(int edge, int& a, int& b) {
    constexpr int first[6] = {0, 1, 0, 0, 1, 2}, second[6] = {1, 2, 2, 3, 3, 3};
    a = first[edge];
    b = second[edge];
}

template <class T>
HEPATICA_HOST_DEVICE TetrahedronRest<T> tetrahedron_rest(const Vector3<T>& x0, const Vector3<T>& x1,
                                                         const Vector3<T>& x2, const Vector3<T>& x3,
                                                         T lambda, T mu) {
    const Vector3<T> a = x1 - x0, b = x2 - x0, c = x3 - x0;
    const T six_volumes = dot(cross(a, b), c);
    const T s = T(1) / six_volumes;
    return {{s * cross(b, c), s * cross(c, a), s * cross(a, b)}, six_volumes / T(6), lambda, mu};
}

namespace detail {

template <int Nodes>
inline constexpr int point_count = Nodes == 4 ? 1 : 4;

// Gradients of the shape functions at integration point q.
template <int Nodes, class T>
HEPATICA_HOST_DEVICE void shape_gradients(const TetrahedronRest<T>& rest, int q, Vector3<T>* g) {
    Vector3<T> corner[4];
    for (int i = 0; i < 3; ++i) corner[i + 1] = rest.gradient[i];
    corner[0] = T(-1) * (rest.gradient[0] + rest.gradient[1] + rest.gradient[2]);
    if constexpr (Nodes == 4) {
        for (int i = 0; i < 4; ++i) g[i] = corner[i];
    } else {
        const T inside = T(0.58541019662496845446), outside = T(0.13819660112501051518);
        T l[4];
        for (int i = 0; i < 4; ++i) l[i] = i == q ? inside : outside;
        for (int i = 0; i < 4; ++i) g[i] = (T(4) * l[i] - T(1)) * corner[i];
        for (int edge = 0; edge < 6; ++edge) {
            int a = 0, b = 0;
            edge_corners(edge, a, b);
            g[4 + edge] = T(4) * (l[a] * corner[b] + l[b] * corner[a]);
        }
    }
}

// Uses differences of positions, so that a translation of the body changes no bit.
template <int Nodes, class T>
HEPATICA_HOST_DEVICE Matrix3<T> deformation_gradient(const Vector3<T>* x, const Vector3<T>* g) {
    Matrix3<T> f = zero_matrix<T>();
    for (int a = 1; a < Nodes; ++a) {
        const Vector3<T> d = x[a] - x[0];
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j) f(i, j) += d[i] * g[a][j];
    }
    return f;
}

// The law of an element. With one point W takes all of lambda; with several, at most 4 mu.
template <int Nodes, template <class> class Law, class T>
HEPATICA_HOST_DEVICE Law<T> law_of(const TetrahedronRest<T>& rest) {
    const T local = Nodes == 4 ? rest.lambda : smaller(rest.lambda, T(4) * rest.mu);
    return {rest.mu, local, rest.lambda - local};
}

// One integration point's part of the nodal forces. `first` overwrites, otherwise it is added. The
// parts sum to zero over the nodes.
template <int Nodes, class Law, class T>
HEPATICA_HOST_DEVICE void add_point_force(const Law& law, const typename Law::Point& point,
                                          T pressure, T weight, const Vector3<T>* g, bool first,
                                          Vector3<T>* force) {
    const Matrix3<T> stress = law.stress(point, pressure);
    Vector3<T> sum{{T(0), T(0), T(0)}};
    for (int a = 1; a < Nodes; ++a) {
        const Vector3<T> share = T(-1) * (weight * (stress * g[a]));
        force[a] = first ? share : force[a] + share;
        sum = sum + share;
    }
    force[0] = first ? T(-1) * sum : force[0] - sum;
}

// One integration point's part of the stiffness blocks. `first` overwrites, otherwise it is added.
template <int Nodes, Tangent tangent, class Law, class T>
HEPATICA_HOST_DEVICE void add_point_stiffness(const Law& law, const typename Law::Point& point,
                                              T pressure, T weight, const Vector3<T>* g, bool first,
                                              Matrix3<T>* blocks) {
    Vector3<T> h[Nodes];
    const auto add = [&](int a, int b, const Matrix3<T>& share) {
        Matrix3<T>& k = blocks[pair_index<Nodes>(a, b)];
        k = first ? share : k + share;
    };
    if constexpr (tangent == Tangent::rotated) {
        for (int a = 0; a < Nodes; ++a) h[a] = point.rotation * g[a];
        for (int a = 0; a < Nodes; ++a) {
            const Vector3<T> sa = (weight * law.mu) * h[a], la = (weight * law.local_lambda) * h[a];
            for (int b = a + 1; b < Nodes; ++b) {
                Matrix3<T> k;
                const T diagonal = dot(sa, h[b]);
                for (int i = 0; i < 3; ++i) {
                    for (int j = 0; j < 3; ++j) k(i, j) = h[b][i] * sa[j] + la[i] * h[b][j];
                    k(i, i) += diagonal;
                }
                add(a, b, k);
            }
        }
    } else {
        const PrincipalTangent<T> principal = law.projected_tangent(point, pressure);
        for (int a = 0; a < Nodes; ++a) h[a] = transposed_times(principal.v, g[a]);
        for (int a = 0; a < Nodes; ++a)
            for (int b = a + 1; b < Nodes; ++b)
                add(a, b, weight * tangent_block(principal, h[a], h[b]));
    }
}

}  // namespace detail

// Energy [nJ] of the element at the positions x [mm]. force (may be null) receives the elastic
// force on each node [uN]. blocks (null with Tangent::none) receives the stiffness blocks of all
// pairs a < b, K = -dforce_a/dx_b [uN/mm]. Diagonal blocks are minus the sum of the others in their
// row, since a translation changes no force.
template <int Nodes, Tangent tangent, template <class> class LawOf, class T>
HEPATICA_HOST_DEVICE T evaluate_tetrahedron(const TetrahedronRest<T>& rest, const Vector3<T>* x,
                                            Vector3<T>* force, Matrix3<T>* blocks) {
    using Law = LawOf<T>;
    const Law law = detail::law_of<Nodes, LawOf>(rest);
    constexpr int points = detail::point_count<Nodes>;
    Vector3<T> g[points][Nodes];
    typename Law::Point point[points];
    T theta = T(0), energy = T(0);
    for (int q = 0; q < points; ++q) {
        detail::shape_gradients<Nodes>(rest, q, g[q]);
        point[q] = Law::at(detail::deformation_gradient<Nodes>(x, g[q]));
        theta += point[q].theta / T(points);
        energy += law.isochoric_energy(point[q]) / T(points);
    }
    energy = rest.volume * (energy + T(0.5) * law.mean_lambda * theta * theta);
    if (!force && !blocks) return energy;

    const T pressure = law.mean_lambda * theta, weight = rest.volume / T(points);
    Vector3<T> h[Nodes];  // gradient of the mean dilatation; used where there are several points
    for (int a = 0; a < Nodes; ++a) h[a] = {{T(0), T(0), T(0)}};
    for (int q = 0; q < points; ++q) {
        if (force)
            detail::add_point_force<Nodes>(law, point[q], pressure, weight, g[q], q == 0, force);
        if constexpr (tangent != Tangent::none) {
            detail::add_point_stiffness<Nodes, tangent>(law, point[q], pressure, weight, g[q],
                                                        q == 0, blocks);
            const Matrix3<T> gradient = Law::theta_gradient(point[q]);
            for (int a = 0; a < Nodes && points > 1; ++a)
                h[a] = h[a] + (T(1) / T(points)) * (gradient * g[q][a]);
        }
    }
    if constexpr (tangent != Tangent::none && points > 1) {
        const T bulk = rest.volume * law.mean_lambda;
        for (int a = 0; a < Nodes; ++a) {
            const Vector3<T> s = bulk * h[a];
            for (int b = a + 1; b < Nodes; ++b) {
                Matrix3<T>& k = blocks[pair_index<Nodes>(a, b)];
                k = k + outer(s, h[b]);
            }
        }
    }
    return energy;
}

// The linear corotated element with its `rotated` stiffness in factored form: turned[a] is the
// gradient of node a's shape function in the rotated frame, times sqrt(mu volume), and
//   K_ab = S + (lambda / mu) S^T + trace(S) I  with  S = turned[b] turned[a]^T:
// twelve numbers instead of fifty-four, and elements with the same ratio lambda / mu can add up S
// first.
template <class T>
HEPATICA_HOST_DEVICE T evaluate_turned_gradients(const TetrahedronRest<T>& rest,
                                                 const Vector3<T>* x, Vector3<T>* force,
                                                 Vector3<T>* turned) {
    using namespace detail;
    const auto law = law_of<4, CorotatedLaw>(rest);
    Vector3<T> g[4];
    shape_gradients<4>(rest, 0, g);
    const auto point = CorotatedLaw<T>::at(deformation_gradient<4>(x, g));
    add_point_force<4>(law, point, T(0), rest.volume, g, true, force);
    const Matrix3<T> turn = root(rest.volume * law.mu) * point.rotation;
    for (int a = 0; a < 4; ++a) turned[a] = turn * g[a];
    return rest.volume * law.isochoric_energy(point);
}

// d^T K d for that stiffness; u[a] is d of node a relative to node 0.
template <class T>
HEPATICA_HOST_DEVICE T quadratic_form(const Vector3<T>* turned, T lambda_over_mu,
                                      const Vector3<T>* u) {
    Matrix3<T> s = zero_matrix<T>();
    for (int a = 1; a < 4; ++a) s = s + outer(u[a], turned[a]);
    return inner(s, s) + inner(s, transpose(s)) + lambda_over_mu * trace(s) * trace(s);
}

}  // namespace hepatica::small
