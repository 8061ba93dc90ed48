// SPDX-License-Identifier: GPL-3.0-or-later
// One writer passes values to one reader; neither ever waits for the other, and the reader always
// gets the newest value. Three slots: one being written, one being read, one in between.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>

namespace hepatica {

template <class T>
class TripleBuffer {
  public:
    // Writer: the slot to fill. It holds an earlier value, whose memory can be reused.
    T& back() { return slots_[back_]; }
    // Writer: makes the filled slot the newest.
    void publish() {
        const std::uint8_t old =
            middle_.exchange(static_cast<std::uint8_t>(back_ | fresh), std::memory_order_acq_rel);
        back_ = old & slot_bits;
    }

    // Reader: takes the newest value; false if it was taken before.
    bool update() {
        if ((middle_.load(std::memory_order_relaxed) & fresh) == 0) return false;
        front_ = middle_.exchange(front_, std::memory_order_acq_rel) & slot_bits;
        return true;
    }
    // Reader: what the last update() took; unchanged until the next one.
    const T& front() const { return slots_[front_]; }

  private:
    static constexpr std::uint8_t slot_bits = 3;
    static constexpr std::uint8_t fresh = 4;

    std::array<T, 3> slots_{};
    std::uint8_t back_ = 0;  // the writer's own
    std::atomic<std::uint8_t> middle_{1};
    std::uint8_t front_ = 2;  // the reader's own
};

}  // namespace hepatica
