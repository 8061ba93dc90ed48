// SPDX-License-Identifier: GPL-3.0-or-later
// An array in a machine's memory. It has one owner and must not outlive its machine. Functions
// throw DeviceError where the device fails.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "gpu/kernels/view.h"
#include "gpu/machine/machine.h"

namespace hepatica::gpu {

template <class T>
class Array {
  public:
    Array() = default;
    // Zero-initialised.
    Array(Machine& machine, std::size_t size)
        : machine_(&machine),
          view_{size > 0 ? static_cast<T*>(machine.allocate(size * sizeof(T))) : nullptr,
                static_cast<int>(size)} {}
    Array(Machine& machine, std::span<const T> values) : Array(machine, values.size()) {
        upload(values);
    }
    Array(Machine& machine, const std::vector<T>& values)
        : Array(machine, std::span<const T>(values)) {}
    ~Array() {
        if (machine_ != nullptr && view_.data != nullptr)
            machine_->release(view_.data, size() * sizeof(T));
    }
    Array(Array&& other) noexcept { swap(other); }
    Array& operator=(Array&& other) noexcept {
        swap(other);
        return *this;
    }
    Array(const Array&) = delete;
    Array& operator=(const Array&) = delete;

    std::size_t size() const { return static_cast<std::size_t>(view_.size); }
    View<T> view() const { return view_; }
    View<const T> read() const { return view_; }

    // Expects as many values as the array has.
    void upload(std::span<const T> values) {
        if (!values.empty()) machine_->upload(view_.data, values.data(), values.size_bytes());
    }
    // Copies the first values of the array.
    void download(std::span<T> values) const {
        if (!values.empty()) machine_->download(values.data(), view_.data, values.size_bytes());
    }

  private:
    void swap(Array& other) {
        std::swap(machine_, other.machine_);
        std::swap(view_, other.view_);
    }

    Machine* machine_ = nullptr;
    View<T> view_;
};

}  // namespace hepatica::gpu
