// SPDX-License-Identifier: GPL-3.0-or-later
// The part of a body that a step computes. Frozen nodes do not move, like fixed ones. Elements
// without a live node, and their rows of the matrix, keep their values. The cost of a step is
// proportional to the live part; changing the live part costs at most as much as a step.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/deform/body/body.h"

namespace hepatica {

// Keeps a reference to the body. Not thread-safe.
class LiveSet {
  public:
    // Consecutive elements are evaluated in packs of this size, see ElementSlots.
    static constexpr int elements_per_pack = 4;

    // All nodes except fixed ones are live.
    explicit LiveSet(const Body& body);
    // Resets to that; to be called after the body's nodes were split.
    void begin_again();

    // Freezes exactly the nodes with frozen[i] != 0. One entry per node.
    void freeze(std::span<const std::uint8_t> frozen);

    // Per node: 1 where it is fixed or frozen, else 0.
    const std::vector<std::uint8_t>& held() const { return held_; }
    // Number of elements with a node that is not frozen (it may be fixed).
    int live_elements() const { return live_elements_; }

    // Ascending: the nodes of all elements with a live node, and the packs of each group that
    // contain such an element.
    std::span<const int> rows() const { return rows_; }
    std::span<const int> packs(std::size_t group) const { return packs_[group]; }

    // Ascending: those rows, and until written() is called also the rows of the former live part.
    // All other rows of the matrix are unchanged.
    std::span<const int> changed_rows() const { return changed_; }
    void written() { changed_ = rows_; }
    // Makes every row count as changed until written() is called.
    void forget_written();

  private:
    void find_rows_and_packs(std::span<const std::uint8_t> frozen);

    const Body& body_;
    std::vector<std::uint8_t> held_;
    std::vector<int> rows_, changed_;
    std::vector<std::vector<int>> packs_;
    int live_elements_ = 0;
};

}  // namespace hepatica
