// SPDX-License-Identifier: GPL-3.0-or-later
// An array of small structures laid out number by number: all first numbers, then all second ones.
// Threads that take one structure after the other then read neighbouring numbers, which costs a
// device a fraction of what it costs to pick them out of whole structures.
#pragma once

#include <cstring>
#include <type_traits>
#include <vector>

#include "gpu/kernels/view.h"

// Loops whose loads a device has under way at once.
#ifdef __CUDACC__
#define HEPATICA_UNROLL _Pragma("unroll")
#else
#define HEPATICA_UNROLL
#endif

namespace hepatica::gpu {

// T consists of numbers of one type alone; Number is that type, const where they are only read.
template <class T, class Number>
struct Planes {
    static constexpr int numbers = static_cast<int>(sizeof(T) / sizeof(Number));
    static_assert(sizeof(T) == numbers * sizeof(Number) && std::is_trivially_copyable_v<T>);

    Number* data = nullptr;
    int size = 0;  // structures

    Planes() = default;
    // Of an array of so many numbers.
    explicit Planes(const View<Number>& view) : data(view.data), size(view.size / numbers) {}

    HEPATICA_HOST_DEVICE bool empty() const { return size == 0; }
    HEPATICA_HOST_DEVICE T operator[](int i) const {
        std::remove_const_t<Number> number[numbers];
        HEPATICA_UNROLL
        for (int k = 0; k < numbers; ++k) number[k] = data[k * size + i];
        T value;
        memcpy(&value, number, sizeof value);
        return value;
    }
    HEPATICA_HOST_DEVICE void set(int i, const T& value) const {
        Number number[numbers];
        memcpy(number, &value, sizeof value);
        HEPATICA_UNROLL
        for (int k = 0; k < numbers; ++k) data[k * size + i] = number[k];
    }
};

template <class T, class Number>
std::size_t bytes_of(const Planes<T, Number>& planes) {
    return static_cast<std::size_t>(planes.size) * sizeof(T);
}

// The numbers of an array of structures in this order.
template <class Number, class T>
std::vector<Number> in_planes(const std::vector<T>& values) {
    constexpr std::size_t numbers = sizeof(T) / sizeof(Number);
    static_assert(sizeof(T) == numbers * sizeof(Number) && std::is_trivially_copyable_v<T>);
    std::vector<Number> planes(numbers * values.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
        Number number[numbers];
        std::memcpy(number, &values[i], sizeof(T));
        for (std::size_t k = 0; k < numbers; ++k) planes[k * values.size() + i] = number[k];
    }
    return planes;
}

template <class Real>
using MatrixPlanes = Planes<small::Matrix3<Real>, const Real>;

}  // namespace hepatica::gpu
