// SPDX-License-Identifier: GPL-3.0-or-later
// An array on a machine whose length changes from step to step, and the host's copy of it: memory
// is taken anew only where it grows, and what is the same is not copied again.
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
    explicit GrowingArray(Machine& machine) : machine_(machine) {}

    // Returns whether anything changed.
    bool set(std::vector<T> values) {
        const bool same = values.size() == values_.size() &&
                          (values.empty() || std::memcmp(values.data(), values_.data(),
                                                         sizeof(T) * values.size()) == 0);
        values_ = std::move(values);
        size_ = values_.size();
        if (same || values_.empty()) return !same;
        reserve(values_.size());
        machine_.upload(array_.view().data, values_.data(), sizeof(T) * values_.size());
        return true;
    }
    // Of this length, with any values, of which the host has none.
    void resize(std::size_t size) {
        size_ = size;
        reserve(size);
    }

    std::size_t size() const { return size_; }
    const std::vector<T>& values() const { return values_; }
    View<T> view(std::size_t begin, std::size_t size) const {
        return {array_.view().data + begin, static_cast<int>(size)};
    }
    View<const T> read() const { return view(0, size()); }

  private:
    void reserve(std::size_t size) {
        if (array_.size() < size) array_ = {machine_, std::max(size, 2 * array_.size())};
    }

    Machine& machine_;
    std::vector<T> values_;
    std::size_t size_ = 0;
    Array<T> array_;
};

}  // namespace hepatica::gpu
