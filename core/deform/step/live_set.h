// SPDX-License-Identifier: GPL-3.0-or-later
// Which part of a body a step computes. Frozen nodes stay where they are, as fixed ones do;
// elements without a live node, and rows of the matrix without one, keep what they hold. So a step
// costs what is live, and a change of what is live costs nothing that a step does not cost.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/deform/body/body.h"

namespace hepatica {

// Keeps a reference to the body. Not thread-safe.
class LiveSet {
  public:
    // Elements are evaluated in packs of so many that follow one another, see ElementSlots.
    static constexpr int elements_per_pack = 4;

    // Everything is live but the fixed nodes.
    explicit LiveSet(const Body& body);

    // Freezes the nodes with frozen[i] != 0 and no others. One entry per node.
    void freeze(std::span<const std::uint8_t> frozen);

    // Of each node: 1 where it is fixed or frozen.
    const std::vector<std::uint8_t>& held() const { return held_; }
    // Elements with a node that is not frozen, be it fixed.
    int live_elements() const { return live_elements_; }

    // Ascending: the nodes of all elements that have a live node, and the packs of each group that
    // hold such an element.
    std::span<const int> rows() const { return rows_; }
    std::span<const int> packs(std::size_t group) const { return packs_[group]; }

    // Those rows, and those of the set before until written() was called: ascending. What is
    // neither among them is in the matrix as it was.
    std::span<const int> changed_rows() const { return changed_; }
    void written() { changed_ = rows_; }
    // Nothing is known of the matrix: every row counts as changed.
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
