// SPDX-License-Identifier: GPL-3.0-or-later
// Which boxes meet: Bullet's dynamic tree of boxes (btDbvt), in single precision, with every box
// rounded outwards, so that it finds at least the pairs that meet in double. What it finds is then
// checked in double: answers do not depend on the tree's history.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "core/contact/surface_patches.h"

namespace hepatica {

// Not thread-safe.
class PatchTree {
  public:
    // One box for each patch; later ones of as many. Boxes are not empty and finite.
    explicit PatchTree(std::span<const Box> boxes);
    ~PatchTree();
    PatchTree(const PatchTree&) = delete;
    PatchTree& operator=(const PatchTree&) = delete;

    // O(moved log n): boxes that are as they were cost nothing.
    void refit(std::span<const Box> boxes);

    // Patches whose boxes meet this one, ascending.
    std::vector<int> meeting(const Box& box) const;
    // Pairs (a < b) whose boxes meet, ascending.
    std::vector<std::array<int, 2>> meeting_pairs() const;

  private:
    struct Implementation;
    std::unique_ptr<Implementation> tree_;
    std::vector<Box> boxes_;
};

}  // namespace hepatica
