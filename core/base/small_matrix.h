// SPDX-License-Identifier: GPL-3.0-or-later
// 3-vectors and 3x3 matrices for code that runs both on the host and on a CUDA device: plain
// arrays, no allocation, no exceptions, templated on the scalar (float or double).
#pragma once

#include <cassert>
#include <cmath>

#ifdef __CUDACC__
#define HEPATICA_HOST_DEVICE __host__ __device__ inline
#else
#define HEPATICA_HOST_DEVICE inline
#endif

namespace hepatica::small {

template <class T>
struct Vector3 {
    T v[3];
    HEPATICA_HOST_DEVICE T& operator[](int i) {
        assert(i >= 0 && i < 3);
        return v[i];
    }
    HEPATICA_HOST_DEVICE const T& operator[](int i) const {
        assert(i >= 0 && i < 3);
        return v[i];
    }
};
static_assert(sizeof(Vector3<double>) == 3 * sizeof(double));

// Row-major: m[row][column].
template <class T>
struct Matrix3 {
    T m[3][3];
    HEPATICA_HOST_DEVICE T& operator()(int i, int j) {
        assert(i >= 0 && i < 3 && j >= 0 && j < 3);
        return m[i][j];
    }
    HEPATICA_HOST_DEVICE const T& operator()(int i, int j) const {
        assert(i >= 0 && i < 3 && j >= 0 && j < 3);
        return m[i][j];
    }
};
static_assert(sizeof(Matrix3<double>) == 9 * sizeof(double));

template <class T>
HEPATICA_HOST_DEVICE Vector3<T> operator+(const Vector3<T>& a, const Vector3<T>& b) {
    return {{a[0] + b[0], a[1] + b[1], a[2] + b[2]}};
}
template <class T>
HEPATICA_HOST_DEVICE Vector3<T> operator-(const Vector3<T>& a, const Vector3<T>& b) {
    return {{a[0] - b[0], a[1] - b[1], a[2] - b[2]}};
}
template <class T>
HEPATICA_HOST_DEVICE Vector3<T> operator*(T s, const Vector3<T>& a) {
    return {{s * a[0], s * a[1], s * a[2]}};
}
template <class T>
HEPATICA_HOST_DEVICE T dot(const Vector3<T>& a, const Vector3<T>& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
template <class T>
HEPATICA_HOST_DEVICE Vector3<T> cross(const Vector3<T>& a, const Vector3<T>& b) {
    return {{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]}};
}

template <class T>
HEPATICA_HOST_DEVICE Matrix3<T> zero_matrix() {
    return {{{T(0), T(0), T(0)}, {T(0), T(0), T(0)}, {T(0), T(0), T(0)}}};
}
template <class T>
HEPATICA_HOST_DEVICE Matrix3<T> identity_matrix() {
    return {{{T(1), T(0), T(0)}, {T(0), T(1), T(0)}, {T(0), T(0), T(1)}}};
}
template <class T>
HEPATICA_HOST_DEVICE Matrix3<T> operator+(const Matrix3<T>& a, const Matrix3<T>& b) {
    Matrix3<T> c;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) c(i, j) = a(i, j) + b(i, j);
    return c;
}
template <class T>
HEPATICA_HOST_DEVICE Matrix3<T> operator-(const Matrix3<T>& a, const Matrix3<T>& b) {
    Matrix3<T> c;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) c(i, j) = a(i, j) - b(i, j);
    return c;
}
template <class T>
HEPATICA_HOST_DEVICE Matrix3<T> operator*(T s, const Matrix3<T>& a) {
    Matrix3<T> c;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) c(i, j) = s * a(i, j);
    return c;
}
template <class T>
HEPATICA_HOST_DEVICE Matrix3<T> operator*(const Matrix3<T>& a, const Matrix3<T>& b) {
    Matrix3<T> c;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            c(i, j) = a(i, 0) * b(0, j) + a(i, 1) * b(1, j) + a(i, 2) * b(2, j);
    return c;
}
template <class T>
HEPATICA_HOST_DEVICE Vector3<T> operator*(const Matrix3<T>& a, const Vector3<T>& x) {
    Vector3<T> y;
    for (int i = 0; i < 3; ++i) y[i] = a(i, 0) * x[0] + a(i, 1) * x[1] + a(i, 2) * x[2];
    return y;
}
template <class T>
HEPATICA_HOST_DEVICE Matrix3<T> transpose(const Matrix3<T>& a) {
    Matrix3<T> c;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) c(i, j) = a(j, i);
    return c;
}
// a^T x
template <class T>
HEPATICA_HOST_DEVICE Vector3<T> transposed_times(const Matrix3<T>& a, const Vector3<T>& x) {
    Vector3<T> y;
    for (int i = 0; i < 3; ++i) y[i] = a(0, i) * x[0] + a(1, i) * x[1] + a(2, i) * x[2];
    return y;
}
// a b^T for matrices
template <class T>
HEPATICA_HOST_DEVICE Matrix3<T> times_transposed(const Matrix3<T>& a, const Matrix3<T>& b) {
    Matrix3<T> c;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            c(i, j) = a(i, 0) * b(j, 0) + a(i, 1) * b(j, 1) + a(i, 2) * b(j, 2);
    return c;
}
template <class T>
HEPATICA_HOST_DEVICE Matrix3<T> outer(const Vector3<T>& a, const Vector3<T>& b) {
    Matrix3<T> c;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) c(i, j) = a[i] * b[j];
    return c;
}
// d det(a) / d a: its columns are the cross products of the other two columns.
template <class T>
HEPATICA_HOST_DEVICE Matrix3<T> cofactor(const Matrix3<T>& a) {
    Matrix3<T> c;
    for (int i = 0; i < 3; ++i) {
        const int i1 = (i + 1) % 3, i2 = (i + 2) % 3;
        for (int j = 0; j < 3; ++j) {
            const int j1 = (j + 1) % 3, j2 = (j + 2) % 3;
            c(i, j) = a(i1, j1) * a(i2, j2) - a(i1, j2) * a(i2, j1);
        }
    }
    return c;
}
template <class T>
HEPATICA_HOST_DEVICE T determinant(const Matrix3<T>& a) {
    return a(0, 0) * (a(1, 1) * a(2, 2) - a(1, 2) * a(2, 1)) -
           a(0, 1) * (a(1, 0) * a(2, 2) - a(1, 2) * a(2, 0)) +
           a(0, 2) * (a(1, 0) * a(2, 1) - a(1, 1) * a(2, 0));
}
template <class T>
HEPATICA_HOST_DEVICE T trace(const Matrix3<T>& a) {
    return a(0, 0) + a(1, 1) + a(2, 2);
}
// Sum of a(i,j) b(i,j).
template <class T>
HEPATICA_HOST_DEVICE T inner(const Matrix3<T>& a, const Matrix3<T>& b) {
    T sum = T(0);
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) sum += a(i, j) * b(i, j);
    return sum;
}

}  // namespace hepatica::small
