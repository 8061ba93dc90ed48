// SPDX-License-Identifier: GPL-3.0-or-later
// Vectors padded to four numbers, which a device loads with one access of 16 bytes where they are
// float. Three separate numbers take three loads, which matters where neighbouring threads read
// distant places.
#pragma once

#include "gpu/kernels/view.h"

namespace hepatica::gpu {

using small::Vector3;

template <class Real>
struct alignas(16) Quad {
    Real number[4];  // the last one is zero
};

template <class Real>
HEPATICA_HOST_DEVICE Quad<Real> quad_of(const Vector3<Real>& v) {
    return {{v[0], v[1], v[2], Real(0)}};
}
template <class Real>
HEPATICA_HOST_DEVICE Vector3<Real> vector_of(const Quad<Real>& q) {
    return {{q.number[0], q.number[1], q.number[2]}};
}
template <class Real>
HEPATICA_HOST_DEVICE const Vector3<Real>& vector_of(const Vector3<Real>& v) {
    return v;
}

// A field is a view of vectors of either kind.
namespace detail {
template <class Real>
Real number_of(const Quad<Real>&);
template <class Real>
Real number_of(const Vector3<Real>&);
}  // namespace detail
template <class Field>
using NumberOf = decltype(detail::number_of(*static_cast<Field*>(nullptr)->data));

}  // namespace hepatica::gpu
