// SPDX-License-Identifier: GPL-3.0-or-later
// A scalar type that holds N values in one vector register (SIMD), so that element functions that
// are written once for a scalar evaluate N elements in one pass. Operations are never fused: every
// lane gets the same bits as the scalar would. Host only.
#pragma once

#include "core/deform/elements/polar_decomposition.h"

namespace hepatica::small {

template <class T, int N>
struct Lanes {
    typedef T Vector __attribute__((vector_size(N * sizeof(T))));  // NOLINT: dependent size
    static constexpr int count = N;

    // The lanes for which a comparison holds.
    struct Mask {
        decltype(Vector{} < Vector{}) bits;
        friend Mask operator&(const Mask& a, const Mask& b) { return {a.bits & b.bits}; }
        friend Mask operator!(const Mask& a) { return {~a.bits}; }
        friend bool any(const Mask& a) {
            bool result = false;
            for (int lane = 0; lane < N; ++lane) result |= a.bits[lane] != 0;
            return result;
        }
        friend Lanes select(const Mask& mask, const Lanes& a, const Lanes& b) {
            return {mask.bits ? a.v : b.v};
        }
    };

    Vector v;

    Lanes() = default;
    Lanes(double a) : v(static_cast<T>(a) - Vector{}) {}
    Lanes(const Vector& a) : v(a) {}

    T operator[](int lane) const { return v[lane]; }
    void set(int lane, T value) { v[lane] = value; }

    friend Lanes operator+(const Lanes& a, const Lanes& b) { return {a.v + b.v}; }
    friend Lanes operator-(const Lanes& a, const Lanes& b) { return {a.v - b.v}; }
    friend Lanes operator*(const Lanes& a, const Lanes& b) { return {a.v * b.v}; }
    friend Lanes operator/(const Lanes& a, const Lanes& b) { return {a.v / b.v}; }
    friend Lanes operator-(const Lanes& a) { return {-a.v}; }
    Lanes& operator+=(const Lanes& a) { return *this = *this + a; }
    Lanes& operator-=(const Lanes& a) { return *this = *this - a; }
    friend Mask operator<(const Lanes& a, const Lanes& b) { return {a.v < b.v}; }
    friend Mask operator>(const Lanes& a, const Lanes& b) { return {a.v > b.v}; }
};

template <class T, int N>
Lanes<T, N> root(const Lanes<T, N>& a) {
    Lanes<T, N> result;
    for (int lane = 0; lane < N; ++lane) result.set(lane, std::sqrt(a[lane]));
    return result;
}

template <class T, int N>
struct ScalarOf<Lanes<T, N>> {
    using type = T;
};

// One lane at a time, because few elements of a body are flat or inverted.
template <class T, int N>
Matrix3<Lanes<T, N>> rotation_by_svd(const Matrix3<Lanes<T, N>>& f,
                                     const typename Lanes<T, N>::Mask& found,
                                     const Matrix3<Lanes<T, N>>& r) {
    Matrix3<Lanes<T, N>> result = r;
    for (int lane = 0; lane < N; ++lane) {
        if (found.bits[lane]) continue;
        Matrix3<T> own;
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j) own(i, j) = f(i, j)[lane];
        const Matrix3<T> turned = rotation_by_svd(own, false, own);
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j) result(i, j).set(lane, turned(i, j));
    }
    return result;
}

}  // namespace hepatica::small
