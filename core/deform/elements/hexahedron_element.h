// SPDX-License-Identifier: GPL-3.0-or-later
// The corotated 8-node hexahedron (future work in the paper), for host and device. Three
// incompatible modes, condensed once at rest, prevent locking in bending and near nu = 1/2 (Wilson
// et al. 1973); with the corrected mode gradients of Taylor, Beresford and Wilson 1976 distorted
// elements pass the patch test.
#pragma once

#include "core/deform/elements/polar_decomposition.h"
#include "core/deform/elements/tetrahedron_element.h"

namespace hepatica::small {

template <class T>
struct HexahedronRest {
    Vector3<T> position[8];  // mm, relative to corner 0; VTK's order of corners
    Vector3<T> gradient[8];  // of the shape functions, averaged over the element
    T stiffness[24][24];     // uN/mm, at rest, with the modes condensed
    T volume;                // mm3
    T guard;                 // Pa, stiffness of the guard against crushing
    T mass_share[8];         // of the element's mass; they add up to 1
};

namespace detail {

// Signs of the corners in the parent cube.
HEPATICA_HOST_DEVICE void hexahedron_corner(int a, int* sign) {
    constexpr int x[8] = {-1, 1, 1, -1, -1, 1, 1, -1}, y[8] = {-1, -1, 1, 1, -1, -1, 1, 1};
    sign[0] = x[a];
    sign[1] = y[a];
    sign[2] = a < 4 ? -1 : 1;
}

// 1/sqrt(3): the integration points of the parent cube are its corners scaled by this.
template <class T>
HEPATICA_HOST_DEVICE T gauss_coordinate() {
    return T(0.57735026918962576451);
}

// Derivatives of the eight shape functions with respect to the parent coordinates, at xi.
template <class T>
HEPATICA_HOST_DEVICE void parent_gradients(const T* xi, Vector3<T>* d) {
    for (int a = 0; a < 8; ++a) {
        int s[3];
        hexahedron_corner(a, s);
        const T fx = T(1) + T(s[0]) * xi[0], fy = T(1) + T(s[1]) * xi[1],
                fz = T(1) + T(s[2]) * xi[2];
        d[a] = {{T(s[0]) * fy * fz / T(8), T(s[1]) * fx * fz / T(8), T(s[2]) * fx * fy / T(8)}};
    }
}

// dx/dxi; rows are components of x.
template <class T>
HEPATICA_HOST_DEVICE Matrix3<T> jacobian(const Vector3<T>* x, const Vector3<T>* d) {
    Matrix3<T> j = zero_matrix<T>();
    for (int a = 0; a < 8; ++a) j = j + outer(x[a], d[a]);
    return j;
}

// Linear elastic stiffness between two shape gradients.
template <class T>
HEPATICA_HOST_DEVICE Matrix3<T> hooke_block(const Vector3<T>& a, const Vector3<T>& b, T lambda,
                                            T mu) {
    return lambda * outer(a, b) + mu * outer(b, a) + (mu * dot(a, b)) * identity_matrix<T>();
}

// Adds one of the eight integration points: its part of the volume, of the integrals of gradients
// and shape functions, and of the stiffness (rows of the nodes first, then of the modes).
template <class T>
HEPATICA_HOST_DEVICE void add_integration_point(int q, const Matrix3<T>& centre_cofactors, T lambda,
                                                T mu, T (*k)[33], HexahedronRest<T>& rest) {
    int s[3];
    hexahedron_corner(q, s);
    T xi[3];
    for (int i = 0; i < 3; ++i) xi[i] = T(s[i]) * gauss_coordinate<T>();
    Vector3<T> d[8];
    parent_gradients(xi, d);
    const Matrix3<T> j = jacobian(rest.position, d);
    const T det = determinant(j);
    const Matrix3<T> cofactors = cofactor(j);
    Vector3<T> g[11];
    for (int a = 0; a < 8; ++a) g[a] = (T(1) / det) * (cofactors * d[a]);
    // Modes 1 - xi_i^2. With the centre's Jacobian, constant stress does no work on them.
    for (int i = 0; i < 3; ++i) g[8 + i] = (T(-2) * xi[i] / det) * column(centre_cofactors, i);
    for (int a = 0; a < 11; ++a)
        for (int b = 0; b < 11; ++b) {
            const Matrix3<T> block = det * hooke_block(g[a], g[b], lambda, mu);
            for (int r = 0; r < 3; ++r)
                for (int c = 0; c < 3; ++c) k[3 * a + r][3 * b + c] += block(r, c);
        }
    rest.volume += det;
    for (int a = 0; a < 8; ++a) {
        int t[3];
        hexahedron_corner(a, t);
        T shape = T(0.125);
        for (int i = 0; i < 3; ++i) shape *= T(1) + T(t[i]) * xi[i];
        rest.mass_share[a] += det * shape;
        rest.gradient[a] = rest.gradient[a] + det * g[a];
    }
}

// Eliminates the last nine unknowns (the modes) from the 33 x 33 stiffness: static condensation.
template <class T>
HEPATICA_HOST_DEVICE void condense_modes(T (*k)[33]) {
    for (int p = 32; p >= 24; --p) {
        const T inverse = T(1) / k[p][p];
        for (int i = 0; i < p; ++i) {
            const T factor = k[i][p] * inverse;
            for (int j = 0; j < p; ++j) k[i][j] -= factor * k[p][j];
        }
    }
}

}  // namespace detail

// Least Jacobian determinant at the corners and the integration points, in mm3 per unit of the
// parent cube. Elements where it is not positive are folded and must be refused.
template <class T>
HEPATICA_HOST_DEVICE T least_jacobian(const Vector3<T>* x) {
    T least = T(0);
    for (int point = 0; point < 16; ++point) {
        int s[3];
        detail::hexahedron_corner(point % 8, s);
        const T reach = point < 8 ? T(1) : detail::gauss_coordinate<T>();
        const T xi[3] = {reach * T(s[0]), reach * T(s[1]), reach * T(s[2])};
        Vector3<T> d[8];
        detail::parent_gradients(xi, d);
        const T det = determinant(detail::jacobian(x, d));
        least = point == 0 ? det : detail::smaller(least, det);
    }
    return least;
}

// Called once per element; needs about 10 kB of stack.
template <class T>
HEPATICA_HOST_DEVICE void hexahedron_rest(const Vector3<T>* x, T lambda, T mu,
                                          HexahedronRest<T>& rest) {
    using namespace detail;
    const T centre[3] = {T(0), T(0), T(0)};
    Vector3<T> d[8];
    for (int a = 0; a < 8; ++a) rest.position[a] = x[a] - x[0];
    parent_gradients(centre, d);
    const Matrix3<T> centre_cofactors = cofactor(jacobian(rest.position, d));
    const T local_lambda = smaller(lambda, T(4) * mu);
    T k[33][33];
    for (auto& row : k)
        for (T& value : row) value = T(0);
    rest.volume = T(0);
    for (int a = 0; a < 8; ++a) {
        rest.gradient[a] = {{T(0), T(0), T(0)}};
        rest.mass_share[a] = T(0);
    }
    for (int q = 0; q < 8; ++q)
        add_integration_point(q, centre_cofactors, local_lambda, mu, k, rest);
    for (int a = 0; a < 8; ++a) {
        rest.gradient[a] = (T(1) / rest.volume) * rest.gradient[a];
        rest.mass_share[a] /= rest.volume;
    }
    rest.guard = local_lambda + T(2) * mu;
    condense_modes(k);
    // The part of lambda above 4 mu resists the mean dilatation, to which the modes do not
    // contribute.
    const T bulk = (lambda - local_lambda) * rest.volume;
    for (int i = 0; i < 24; ++i)
        for (int j = 0; j < 24; ++j)
            rest.stiffness[i][j] = T(0.5) * (k[i][j] + k[j][i]) +
                                   bulk * rest.gradient[i / 3][i % 3] * rest.gradient[j / 3][j % 3];
}

// As evaluate_tetrahedron, with the `rotated` stiffness. The energy is 1/2 d^T K d with d = R^T x -
// X, plus guard/2 V (det F - 0.3)^2 where det F < 0.3. The force is the exact gradient of both,
// including the dependence of R on x. R is not unique, and the energy not smooth, where the two
// smaller singular values of F (the smallest counted negative where F is inverted) add up to zero.
template <class T>
HEPATICA_HOST_DEVICE T evaluate_hexahedron(const HexahedronRest<T>& rest, const Vector3<T>* x,
                                           Vector3<T>* force, Matrix3<T>* blocks) {
    Matrix3<T> f = zero_matrix<T>();
    for (int a = 1; a < 8; ++a) f = f + outer(x[a] - x[0], rest.gradient[a]);
    const Matrix3<T> r = nearest_rotation(f);
    Vector3<T> y[8], d[8], pull[8];
    for (int a = 0; a < 8; ++a) {
        y[a] = transposed_times(r, x[a] - x[0]);
        d[a] = y[a] - rest.position[a];
    }
    T energy = T(0);
    Vector3<T> torque{{T(0), T(0), T(0)}};
    for (int a = 0; a < 8; ++a) {
        for (int i = 0; i < 3; ++i) {
            pull[a][i] = T(0);
            for (int b = 1; b < 8; ++b)
                for (int j = 0; j < 3; ++j)
                    pull[a][i] += rest.stiffness[3 * a + i][3 * b + j] * d[b][j];
        }
        energy += T(0.5) * dot(d[a], pull[a]);
        torque = torque + cross(y[a], pull[a]);
    }
    // The guard is needed because the rotated frame cannot tell an inverted face from an intact
    // one.
    const Matrix3<T> cofactors = cofactor(f);  // the derivative of det F by F
    const T crushed = detail::smaller(determinant(f) - T(0.3), T(0));
    energy += T(0.5) * rest.guard * rest.volume * crushed * crushed;
    if (force) {
        // delta theta = G^-1 sum grad N x R^T delta x, with G = trace(S) - S and S = R^T F.
        const Matrix3<T> s = transpose(r) * f;
        Matrix3<T> turn = trace(s) * identity_matrix<T>() - T(0.5) * (s + transpose(s));
        const T det = determinant(turn), size = detail::largest_entry(turn);
        Vector3<T> w{{T(0), T(0), T(0)}};
        if (det > T(1e-6) * size * size * size) w = (T(1) / det) * (cofactor(turn) * torque);
        for (int a = 0; a < 8; ++a) force[a] = T(-1) * (r * (pull[a] - cross(w, rest.gradient[a])));
        const T push = rest.guard * rest.volume * crushed;
        for (int a = 0; a < 8 && crushed < T(0); ++a)
            force[a] = force[a] - push * (cofactors * rest.gradient[a]);
    }
    if (blocks) {
        for (int a = 0; a < 8; ++a)
            for (int b = a + 1; b < 8; ++b) {
                Matrix3<T> k;
                for (int i = 0; i < 3; ++i)
                    for (int j = 0; j < 3; ++j) k(i, j) = rest.stiffness[3 * a + i][3 * b + j];
                Matrix3<T>& block = blocks[pair_index<8>(a, b)];
                block = r * times_transposed(k, r);
                if (crushed < T(0))
                    block =
                        block + (rest.guard * rest.volume) * outer(cofactors * rest.gradient[a],
                                                                   cofactors * rest.gradient[b]);
            }
    }
    return energy;
}

}  // namespace hepatica::small
