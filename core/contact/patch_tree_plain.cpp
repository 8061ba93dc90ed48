// SPDX-License-Identifier: GPL-3.0-or-later
// The same answers where Bullet is not there: all pairs of boxes, O(n^2).
#include "core/contact/patch_tree.h"

namespace hepatica {

struct PatchTree::Implementation {};

PatchTree::PatchTree(std::span<const Box> boxes) : boxes_(boxes.begin(), boxes.end()) {}

PatchTree::~PatchTree() = default;

void PatchTree::refit(std::span<const Box> boxes) {
    boxes_.assign(boxes.begin(), boxes.end());
}

std::vector<int> PatchTree::meeting(const Box& box) const {
    std::vector<int> found;
    for (std::size_t i = 0; i < boxes_.size(); ++i)
        if (boxes_[i].meets(box)) found.push_back(static_cast<int>(i));
    return found;
}

std::vector<std::array<int, 2>> PatchTree::meeting_pairs() const {
    std::vector<std::array<int, 2>> found;
    for (std::size_t i = 0; i < boxes_.size(); ++i)
        for (std::size_t j = i + 1; j < boxes_.size(); ++j)
            if (boxes_[i].meets(boxes_[j]))
                found.push_back({static_cast<int>(i), static_cast<int>(j)});
    return found;
}

}  // namespace hepatica
