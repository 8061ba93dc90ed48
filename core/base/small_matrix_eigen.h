// SPDX-License-Identifier: GPL-3.0-or-later
// Conversion between Eigen's vectors and matrices and those of small_matrix.h. Host only.
#pragma once

#include "core/base/small_matrix.h"
#include "core/base/vector.h"

namespace hepatica::small {

inline Vector3<double> from_eigen(const Vec3& x) {
    return {{x[0], x[1], x[2]}};
}
inline Matrix3<double> from_eigen(const Mat3& a) {
    Matrix3<double> b;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) b(i, j) = a(i, j);
    return b;
}
inline Vec3 to_eigen(const Vector3<double>& x) {
    return Vec3(x[0], x[1], x[2]);
}
inline Mat3 to_eigen(const Matrix3<double>& a) {
    Mat3 b;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) b(i, j) = a(i, j);
    return b;
}

}  // namespace hepatica::small
