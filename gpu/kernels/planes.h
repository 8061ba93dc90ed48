// SPDX-License-Identifier: GPL-3.0-or-later
// An array of small structures in planes: first the first 16 bytes of every structure, then the
// second 16 bytes, and so on; the remainder follows number by number. Threads that read consecutive
// structures then read neighbouring memory, 16 bytes at once, which costs a device a fraction of
// reading numbers out of whole structures.
#pragma once

#include <cstring>
#include <type_traits>
#include <vector>

#include "gpu/kernels/view.h"

// Unrolls a loop so that a device has all its loads in flight at once.
#ifdef __CUDACC__
#define HEPATICA_UNROLL _Pragma("unroll")
#else
#define HEPATICA_UNROLL
#endif

namespace hepatica::gpu {

// T consists of numbers of one type, which is Number; const where they are only read. The array
// must be aligned to 16 bytes.
template <class T, class Number>
struct Planes {
    static constexpr int numbers = static_cast<int>(sizeof(T) / sizeof(Number));
    static constexpr int at_once = static_cast<int>(16 / sizeof(Number));
    static constexpr int parts = numbers / at_once, in_parts = parts * at_once;
    static_assert(sizeof(T) == numbers * sizeof(Number) && std::is_trivially_copyable_v<T>);

    Number* data = nullptr;
    int size = 0;  // structures

    Planes() = default;
    // From an array of their numbers.
    explicit Planes(const View<Number>& view) : data(view.data), size(view.size / numbers) {}

    HEPATICA_HOST_DEVICE bool empty() const { return size == 0; }
    HEPATICA_HOST_DEVICE T operator[](int i) const {
        Value number[numbers];
        HEPATICA_UNROLL
        for (int k = 0; k < parts; ++k) {
            const Part part = reinterpret_cast<const Part*>(data)[k * size + i];
            for (int c = 0; c < at_once; ++c) number[k * at_once + c] = part.number[c];
        }
        HEPATICA_UNROLL
        for (int k = in_parts; k < numbers; ++k) number[k] = data[k * size + i];
        T value;
        memcpy(&value, number, sizeof value);
        return value;
    }
    HEPATICA_HOST_DEVICE void set(int i, const T& value) const {
        Value number[numbers];
        memcpy(number, &value, sizeof value);
        HEPATICA_UNROLL
        for (int k = 0; k < parts; ++k) {
            Part part;
            for (int c = 0; c < at_once; ++c) part.number[c] = number[k * at_once + c];
            reinterpret_cast<Part*>(data)[k * size + i] = part;
        }
        HEPATICA_UNROLL
        for (int k = in_parts; k < numbers; ++k) data[k * size + i] = number[k];
    }

  private:
    using Value = std::remove_const_t<Number>;
    struct alignas(16) Part {
        Value number[at_once];
    };
};

template <class T, class Number>
std::size_t bytes_of(const Planes<T, Number>& planes) {
    return static_cast<std::size_t>(planes.size) * sizeof(T);
}

// The numbers of an array of structures in this layout.
template <class Number, class T>
std::vector<Number> in_planes(const std::vector<T>& values) {
    using Layout = Planes<T, Number>;
    std::vector<Number> planes(Layout::numbers * values.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
        Number number[Layout::numbers];
        std::memcpy(number, &values[i], sizeof(T));
        for (std::size_t k = 0; k < Layout::numbers; ++k) {
            const std::size_t part = k / Layout::at_once, c = k % Layout::at_once;
            planes[k < Layout::in_parts ? (part * values.size() + i) * Layout::at_once + c
                                        : k * values.size() + i] = number[k];
        }
    }
    return planes;
}

template <class Real>
using MatrixPlanes = Planes<small::Matrix3<Real>, const Real>;

}  // namespace hepatica::gpu
