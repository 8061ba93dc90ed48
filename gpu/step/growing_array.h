// SPDX-License-Identifier: GPL-3.0-or-later
// An array on a machine whose length may change, with a copy on the host. Memory is reallocated
// only when it grows, and set() uploads only the parts that changed. Functions throw DeviceError
// where the device fails.
#pragma once

#include <algorithm>
#include <cstring>
#include <type_traits>
#include <utility>
#include <vector>

#include "gpu/machine/array.h"

namespace hepatica::gpu {

template <class T>
class GrowingArray {
    static_assert(std::is_trivially_copyable_v<T>);

  public:
    explicit GrowingArray(Machine& machine) : machine_(&machine) {}

    void set(std::vector<T> values) {
        const std::size_t size = values.size();
        // Reallocated memory holds none of the former values.
        const std::size_t known = reserve(size) ? 0 : std::min(size, values_.size());
        const auto same = [&](std::size_t begin) {
            const std::size_t end = std::min(begin + part, size);
            return end <= known && std::memcmp(values.data() + begin, values_.data() + begin,
                                               sizeof(T) * (end - begin)) == 0;
        };
        for (std::size_t begin = 0, end; begin < size; begin = end + part) {
            for (end = begin; end < size && !same(end);) end += part;
            if (end == begin) continue;
            machine_->upload(array_.view().data + begin, values.data() + begin,
                             sizeof(T) * (std::min(end, size) - begin));
        }
        values_ = std::move(values);
        size_ = size;
    }
    // Changes the length; the values are undefined, and the host has no copy of them.
    void resize(std::size_t size) {
        size_ = size;
        reserve(size);
    }

    std::size_t size() const { return size_; }
    const std::vector<T>& values() const { return values_; }
    View<T> view(std::size_t begin, std::size_t size) const {
        return {array_.view().data + begin, static_cast<int>(size)};
    }
    View<T> view() const { return view(0, size()); }
    View<const T> read() const { return view(); }

  private:
    // Elements compared at once. Starting a copy costs as much as transferring some hundred
    // kilobytes.
    static constexpr std::size_t part = std::max<std::size_t>(1, 16384 / sizeof(T));

    // Returns true if memory was reallocated: first the size asked for, later a quarter more.
    bool reserve(std::size_t size) {
        if (size <= array_.size()) return false;
        array_ = {*machine_, array_.size() == 0 ? size : size + size / 4};
        return true;
    }

    Machine* machine_;
    std::vector<T> values_;
    std::size_t size_ = 0;
    Array<T> array_;
};

}  // namespace hepatica::gpu
