// SPDX-License-Identifier: GPL-3.0-or-later
// Which boxes meet, by Bullet's dynamic bounding volume tree (btDbvt). It is in single precision
// with every box rounded outwards, so that it finds at least the pairs that meet in double. These
// are then tested in double, so that answers do not depend on the tree's history.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "core/contact/surface_patches.h"

namespace hepatica {

// Not thread-safe.
class PatchTree {
  public:
    // One box per patch; refit() needs as many. Boxes must be finite and not empty.
    explicit PatchTree(std::span<const Box> boxes);
    ~PatchTree();
    PatchTree(const PatchTree&) = delete;
    PatchTree& operator=(const PatchTree&) = delete;

    // O(moved log n): unchanged boxes cost nothing.
    void refit(std::span<const Box> boxes);

    // Pairs (a < b) whose boxes meet, ascending.
    std::vector<std::array<int, 2>> meeting_pairs() const;

  private:
    struct Implementation;
    std::unique_ptr<Implementation> tree_;
    std::vector<Box> boxes_;
};

}  // namespace hepatica
