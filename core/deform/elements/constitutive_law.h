// SPDX-License-Identifier: GPL-3.0-or-later
// Strain energy, stress and stiffness at one point of an elastic body, for host and device. Every
// law is W(F) + U(theta): theta measures dilatation, and U depends on its mean over the element,
// which prevents volumetric locking (mean dilatation; Nagtegaal, Parks and Rice 1974). Lame's
// lambda is split between the two: W takes the part that causes no locking at a point, U the rest.
// - Corotated: theta = trace(R^T F) - 3, W = mu |F - R|^2 + local_lambda/2 theta^2
// - NeoHookean: the stable form of Smith, de Goes and Kim 2018, theta = J - 1; mu' = 4/3 mu and
//   lambda' = lambda + 5/6 mu make it agree with Hooke's law for small strains
#pragma once

#include "core/base/small_matrix.h"
#include "core/deform/elements/polar_decomposition.h"

namespace hepatica::small {

// dP/dF of an isotropic law in its principal frame (F = u diag(sigma) v^T): with G = u^T dF v,
//   dP'_ii = sum_j normal(i,j) G_jj,   dP'_ij = shear[k] G_ij + swap[k] G_ji,  k = 3 - i - j.
template <class T>
struct PrincipalTangent {
    Matrix3<T> u;
    Matrix3<T> v;
    Matrix3<T> normal;
    T shear[3];
    T swap[3];
};

namespace detail {

// The nearest positive semidefinite matrix to a symmetric one: negative eigenvalues become zero.
template <class T>
HEPATICA_HOST_DEVICE Matrix3<T> clamp_negative_eigenvalues(const Matrix3<T>& a) {
    Matrix3<T> d = a;
    Matrix3<T> q = identity_matrix<T>();
    for (int sweep = 0; sweep < 12; ++sweep) {
        const T off = d(0, 1) * d(0, 1) + d(0, 2) * d(0, 2) + d(1, 2) * d(1, 2);
        if (!(off > epsilon<T>() * epsilon<T>() * inner(d, d))) break;
        for (int p = 0; p < 2; ++p)
            for (int r = p + 1; r < 3; ++r) {
                if (d(p, r) == T(0)) continue;
                const T zeta = (d(r, r) - d(p, p)) / (T(2) * d(p, r));
                const T t =
                    (zeta < T(0) ? T(-1) : T(1)) / (absolute(zeta) + root(T(1) + zeta * zeta));
                const T c = T(1) / root(T(1) + t * t), s = c * t;
                Matrix3<T> j = identity_matrix<T>();
                j(p, p) = c;
                j(r, r) = c;
                j(p, r) = s;
                j(r, p) = -s;
                d = transpose(j) * (d * j);
                q = q * j;
            }
    }
    if (d(0, 0) >= T(0) && d(1, 1) >= T(0) && d(2, 2) >= T(0)) return a;
    Matrix3<T> clamped = zero_matrix<T>();
    for (int k = 0; k < 3; ++k) {
        const Vector3<T> e = column(q, k);
        clamped = clamped + larger(d(k, k), T(0)) * outer(e, e);
    }
    return clamped;
}

// Sets shear and swap of pair k from the stiffness for the symmetric (flip) and the antisymmetric
// (twist) change, each clamped to at least zero.
template <class T>
HEPATICA_HOST_DEVICE void set_pair(PrincipalTangent<T>& tangent, int k, T flip, T twist) {
    flip = larger(flip, T(0));
    twist = larger(twist, T(0));
    tangent.shear[k] = T(0.5) * (flip + twist);
    tangent.swap[k] = T(0.5) * (flip - twist);
}

}  // namespace detail

template <class T>
struct CorotatedLaw {
    T mu;
    T local_lambda;  // acts at every point
    T mean_lambda;   // acts on the mean dilatation; Lame's lambda is the sum of both

    struct Point {
        Matrix3<T> f;
        Matrix3<T> rotation;
        T theta;
    };

    HEPATICA_HOST_DEVICE static Point at(const Matrix3<T>& f) {
        const Matrix3<T> r = nearest_rotation(f);
        return {f, r, inner(r, f - r)};
    }
    HEPATICA_HOST_DEVICE static Matrix3<T> theta_gradient(const Point& point) {
        return point.rotation;
    }
    HEPATICA_HOST_DEVICE T isochoric_energy(const Point& point) const {
        const Matrix3<T> d = point.f - point.rotation;
        return mu * inner(d, d) + T(0.5) * local_lambda * point.theta * point.theta;
    }
    HEPATICA_HOST_DEVICE Matrix3<T> stress(const Point& point, T p) const {
        return T(2) * mu * (point.f - point.rotation) +
               (p + local_lambda * point.theta) * point.rotation;
    }

    // Hessian of W + p theta, projected onto the positive semidefinite matrices.
    HEPATICA_HOST_DEVICE PrincipalTangent<T> projected_tangent(const Point& point, T p) const {
        using namespace detail;
        const SignedSvd<T> svd = signed_svd(point.f);
        PrincipalTangent<T> tangent;
        tangent.u = svd.u;
        tangent.v = svd.v;
        const Vector3<T> one{{T(1), T(1), T(1)}};
        tangent.normal = T(2) * mu * identity_matrix<T>() + local_lambda * outer(one, one);
        const T pull = T(2) * (p + local_lambda * point.theta) - T(4) * mu;
        const T tiny = epsilon<T>() * (absolute(svd.sigma[0]) + T(1));
        for (int k = 0; k < 3; ++k) {
            const T sum = larger(svd.sigma[(k + 1) % 3] + svd.sigma[(k + 2) % 3], tiny);
            set_pair(tangent, k, T(2) * mu, T(2) * mu + pull / sum);
        }
        return tangent;
    }
};

template <class T>
struct NeoHookeanLaw {
    T mu;  // Lame's, not mu' = 4/3 mu
    T local_lambda;
    T mean_lambda;

    struct Point {
        Matrix3<T> f;
        Matrix3<T> cofactors;
        T theta;   // J - 1
        T first;   // I - 3
        T second;  // (I - 3) / 2 - (J - 1): of second order near rest
    };

    // Computed from the displacement gradient g = f - 1, so that nothing cancels near rest.
    HEPATICA_HOST_DEVICE static Point at(const Matrix3<T>& f) {
        Matrix3<T> g = f;
        for (int i = 0; i < 3; ++i) g(i, i) -= T(1);
        const T sum = trace(g), squares = inner(g, g);
        const T higher = T(0.5) * (sum * sum - inner(g, transpose(g))) + determinant(g);
        return {f, cofactor(f), sum + higher, T(2) * sum + squares, T(0.5) * squares - higher};
    }
    HEPATICA_HOST_DEVICE static Matrix3<T> theta_gradient(const Point& point) {
        return point.cofactors;
    }
    // mu'/2 (I - 3) - mu'/2 log((I + 1)/4) - 3/4 mu' (J - 1) + 5/12 mu (J - 1)^2. With lambda/2 (J
    // - 1)^2 this is the published energy, split so that each part is stable by itself.
    HEPATICA_HOST_DEVICE T isochoric_energy(const Point& point) const {
        const T quarter = T(0.25) * point.first, d = point.theta;
        return mu * (point.second + T(2) / T(3) * (quarter - std::log1p(quarter))) +
               T(0.5) * local_bulk() * d * d;
    }
    HEPATICA_HOST_DEVICE Matrix3<T> stress(const Point& point, T p) const {
        const T ic = inner(point.f, point.f);
        const T stretch = T(4) / T(3) * mu * (T(1) - T(1) / (ic + T(1)));
        return stretch * point.f + (p + local_pressure(point)) * point.cofactors;
    }

    // Hessian of W + p theta, projected onto the positive semidefinite matrices.
    HEPATICA_HOST_DEVICE PrincipalTangent<T> projected_tangent(const Point& point, T p) const {
        using namespace detail;
        const SignedSvd<T> svd = signed_svd(point.f);
        PrincipalTangent<T> tangent;
        tangent.u = svd.u;
        tangent.v = svd.v;
        const Vector3<T>& s = svd.sigma;
        const Vector3<T> area{{s[1] * s[2], s[0] * s[2], s[0] * s[1]}};
        const T m = T(4) / T(3) * mu, plus = T(1) / (dot(s, s) + T(1)), stretch = m * (T(1) - plus),
                total = p + local_pressure(point);
        tangent.normal = (T(2) * m * plus * plus) * outer(s, s) + stretch * identity_matrix<T>() +
                         local_bulk() * outer(area, area);
        for (int k = 0; k < 3; ++k) {
            const int i = (k + 1) % 3, j = (k + 2) % 3;
            tangent.normal(i, j) += total * s[k];
            tangent.normal(j, i) += total * s[k];
            set_pair(tangent, k, stretch - total * s[k], stretch + total * s[k]);
        }
        tangent.normal = clamp_negative_eigenvalues(tangent.normal);
        return tangent;
    }

  private:
    HEPATICA_HOST_DEVICE T local_pressure(const Point& point) const {
        return local_bulk() * point.theta - mu;
    }
    HEPATICA_HOST_DEVICE T local_bulk() const { return T(5) / T(6) * mu + local_lambda; }
};

// The 3x3 block of  sum dP/dF : (a (x) b)  for two shape gradients in the principal frame, a' = v^T
// grad N_a: the derivative of the force P grad N_a with respect to the position of node b.
template <class T>
HEPATICA_HOST_DEVICE Matrix3<T> tangent_block(const PrincipalTangent<T>& tangent,
                                              const Vector3<T>& a, const Vector3<T>& b) {
    Matrix3<T> k;
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3, l = (i + 2) % 3;
        k(i, i) = tangent.normal(i, i) * a[i] * b[i] + tangent.shear[l] * a[j] * b[j] +
                  tangent.shear[j] * a[l] * b[l];
        k(i, j) = tangent.normal(i, j) * a[i] * b[j] + tangent.swap[l] * a[j] * b[i];
        k(i, l) = tangent.normal(i, l) * a[i] * b[l] + tangent.swap[j] * a[l] * b[i];
    }
    return tangent.u * times_transposed(k, tangent.u);
}

}  // namespace hepatica::small
