// SPDX-License-Identifier: GPL-3.0-or-later
// A plain array as seen by a kernel, on host and device alike. Does not own its memory.
#pragma once

#include <cstddef>
#include <type_traits>

#include "core/base/small_matrix.h"

namespace hepatica::gpu {

template <class T>
struct View {
    T* data = nullptr;
    int size = 0;

    View() = default;
    HEPATICA_HOST_DEVICE View(T* begin, int count) : data(begin), size(count) {}
    // Conversion to a read-only view.
    template <class U, class = std::enable_if_t<std::is_same_v<const U, T>>>
    HEPATICA_HOST_DEVICE View(const View<U>& other) : data(other.data), size(other.size) {}

    HEPATICA_HOST_DEVICE T& operator[](int i) const { return data[i]; }
    HEPATICA_HOST_DEVICE bool empty() const { return size == 0; }
};

// Bytes of the arrays, as a lower bound of what a kernel moves: every array is counted once per use
// (twice where it is read and written). Additional traffic of cache misses is not counted.
template <class... T>
std::size_t bytes_of(const View<T>&... views) {
    return (std::size_t{0} + ... + (static_cast<std::size_t>(views.size) * sizeof(T)));
}

}  // namespace hepatica::gpu
