// SPDX-License-Identifier: GPL-3.0-or-later
// The rotation nearest to a deformation gradient. Its determinant is +1 for every input: stretched,
// flat, inverted or zero. Newton's iteration (Higham 1986) where the matrix is well-conditioned,
// otherwise a one-sided Jacobi singular value decomposition (Hestenes 1958).
#pragma once

#include "core/base/small_matrix.h"

namespace hepatica::small {

// f = u diag(sigma) v^T with rotations u and v (determinant +1). |sigma| is descending; sigma[2]
// alone may be negative, and is exactly where f is inverted.
template <class T>
struct SignedSvd {
    Matrix3<T> u;
    Vector3<T> sigma;
    Matrix3<T> v;
};

// The type of one value: T itself, or of one lane for the Lanes of lanes.h.
template <class T>
struct ScalarOf {
    using type = T;
};
template <class T>
inline constexpr bool is_double = sizeof(typename ScalarOf<T>::type) == sizeof(double);

// Conditions as functions, so that each lane of a Lanes can choose for itself.
template <class T>
HEPATICA_HOST_DEVICE T select(bool condition, const T& a, const T& b) {
    return condition ? a : b;
}
HEPATICA_HOST_DEVICE bool any(bool condition) {
    return condition;
}

namespace detail {

template <class T>
HEPATICA_HOST_DEVICE T epsilon() {
    return is_double<T> ? T(2.220446049250313e-16) : T(1.1920929e-7);
}
template <class T>
HEPATICA_HOST_DEVICE T absolute(T a) {
    return select(a < T(0), -a, a);
}
template <class T>
HEPATICA_HOST_DEVICE T larger(T a, T b) {
    return select(a > b, a, b);
}
template <class T>
HEPATICA_HOST_DEVICE T smaller(T a, T b) {
    return select(a < b, a, b);
}
template <class T>
HEPATICA_HOST_DEVICE T root(T a) {
    return std::sqrt(a);
}

// Largest absolute entry. Dividing by it keeps squares from overflowing.
template <class T>
HEPATICA_HOST_DEVICE T largest_entry(const Matrix3<T>& a) {
    T largest = T(0);
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) largest = larger(largest, absolute(a(i, j)));
    return largest;
}

template <class T>
HEPATICA_HOST_DEVICE Vector3<T> column(const Matrix3<T>& a, int j) {
    return {{a(0, j), a(1, j), a(2, j)}};
}
template <class T>
HEPATICA_HOST_DEVICE void set_column(Matrix3<T>& a, int j, const Vector3<T>& x) {
    for (int i = 0; i < 3; ++i) a(i, j) = x[i];
}
template <class T>
HEPATICA_HOST_DEVICE void swap_columns(Matrix3<T>& a, int p, int q) {
    for (int i = 0; i < 3; ++i) {
        const T kept = a(i, p);
        a(i, p) = a(i, q);
        a(i, q) = -kept;  // one sign changes, so that the determinant is kept
    }
}

// A unit vector orthogonal to the unit vector x.
template <class T>
HEPATICA_HOST_DEVICE Vector3<T> orthogonal_unit(const Vector3<T>& x) {
    int axis = 0;
    for (int i = 1; i < 3; ++i)
        if (absolute(x[i]) < absolute(x[axis])) axis = i;
    Vector3<T> e{{T(0), T(0), T(0)}};
    e[axis] = T(1);
    const Vector3<T> y = cross(x, e);
    return (T(1) / root(dot(y, y))) * y;
}

// Jacobi rotation of columns p and q of b (and of v) that makes them orthogonal in b. False if they
// already were.
template <class T>
HEPATICA_HOST_DEVICE bool orthogonalise_columns(Matrix3<T>& b, Matrix3<T>& v, int p, int q) {
    const Vector3<T> x = column(b, p), y = column(b, q);
    const T xx = dot(x, x), yy = dot(y, y), xy = dot(x, y);
    if (absolute(xy) <= T(2) * epsilon<T>() * root(xx * yy) || xy == T(0)) return false;
    const T zeta = (yy - xx) / (T(2) * xy);
    const T t = (zeta < T(0) ? T(-1) : T(1)) / (absolute(zeta) + root(T(1) + zeta * zeta));
    const T c = T(1) / root(T(1) + t * t), s = c * t;
    for (int i = 0; i < 3; ++i) {
        const T bp = b(i, p), bq = b(i, q), vp = v(i, p), vq = v(i, q);
        b(i, p) = c * bp - s * bq;
        b(i, q) = s * bp + c * bq;
        v(i, p) = c * vp - s * vq;
        v(i, q) = s * vp + c * vq;
    }
    return true;
}

}  // namespace detail

template <class T>
HEPATICA_HOST_DEVICE SignedSvd<T> signed_svd(const Matrix3<T>& f) {
    using namespace detail;
    SignedSvd<T> svd{identity_matrix<T>(), {{T(0), T(0), T(0)}}, identity_matrix<T>()};
    const T scale = largest_entry(f);
    if (!(scale > T(0))) return svd;
    Matrix3<T> b = (T(1) / scale) * f;
    for (int sweep = 0; sweep < 30; ++sweep) {
        bool turned = orthogonalise_columns(b, svd.v, 0, 1);
        turned = orthogonalise_columns(b, svd.v, 0, 2) || turned;
        turned = orthogonalise_columns(b, svd.v, 1, 2) || turned;
        if (!turned) break;
    }
    T norm[3];
    for (int j = 0; j < 3; ++j) norm[j] = root(dot(column(b, j), column(b, j)));
    const int order[3][2] = {{0, 1}, {1, 2}, {0, 1}};
    for (const auto& pair : order) {
        if (norm[pair[0]] >= norm[pair[1]]) continue;
        swap_columns(b, pair[0], pair[1]);
        swap_columns(svd.v, pair[0], pair[1]);
        const T kept = norm[pair[0]];
        norm[pair[0]] = norm[pair[1]];
        norm[pair[1]] = kept;
    }
    const Vector3<T> u0 = (T(1) / norm[0]) * column(b, 0);
    Vector3<T> u1 = column(b, 1) - dot(column(b, 1), u0) * u0;
    const T length1 = root(dot(u1, u1));
    u1 = length1 > T(16) * epsilon<T>() * norm[0] ? (T(1) / length1) * u1 : orthogonal_unit(u0);
    const Vector3<T> u2 = cross(u0, u1);
    set_column(svd.u, 0, u0);
    set_column(svd.u, 1, u1);
    set_column(svd.u, 2, u2);
    svd.sigma = {{scale * norm[0], scale * dot(u1, column(b, 1)), scale * dot(u2, column(b, 2))}};
    return svd;
}

// Returns r where `found`, otherwise the rotation nearest to f by singular value decomposition.
template <class T>
HEPATICA_HOST_DEVICE Matrix3<T> rotation_by_svd(const Matrix3<T>& f, bool found,
                                                const Matrix3<T>& r) {
    if (found) return r;
    const SignedSvd<T> svd = signed_svd(f);
    return times_transposed(svd.u, svd.v);
}

// The rotation r (determinant +1) that maximises trace(r^T f). Finite for every finite f.
template <class T>
HEPATICA_HOST_DEVICE Matrix3<T> nearest_rotation(const Matrix3<T>& f) {
    using namespace detail;
    // Convergence is quadratic: after a change of sqrt(epsilon) the next one is below rounding.
    const T enough = is_double<T> ? T(1e-8) : T(2e-4);
    Matrix3<T> x = f, c = cofactor(x);
    T det = x(0, 0) * c(0, 0) + x(0, 1) * c(0, 1) + x(0, 2) * c(0, 2);
    // Newton's iteration is slow far from a rotation and inexact near a singular matrix.
    const auto regular = (det > T(0.01)) & (inner(x, x) < T(100));
    auto turning = regular;
    for (int iteration = 0; iteration < 12 && any(turning); ++iteration) {
        if (iteration > 0) {
            c = cofactor(x);
            det = x(0, 0) * c(0, 0) + x(0, 1) * c(0, 1) + x(0, 2) * c(0, 2);
        }
        const T scale = T(0.5) / det;
        T change = T(0);
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j) {
                const T next = T(0.5) * x(i, j) + scale * c(i, j);
                change = larger(change, absolute(next - x(i, j)));
                x(i, j) = select(turning, next, x(i, j));
            }
        turning = turning & !(change < enough);
    }
    const auto found = regular & !turning;
    return any(!found) ? rotation_by_svd(f, found, x) : x;
}

}  // namespace hepatica::small
