// SPDX-License-Identifier: GPL-3.0-or-later
// PatchTree without Bullet, with the same answers: sweep and prune along x.
#include <algorithm>
#include <numeric>

#include "core/contact/patch_tree.h"

namespace hepatica {

struct PatchTree::Implementation {};

PatchTree::PatchTree(std::span<const Box> boxes) : boxes_(boxes.begin(), boxes.end()) {}

PatchTree::~PatchTree() = default;

void PatchTree::refit(std::span<const Box> boxes) {
    boxes_.assign(boxes.begin(), boxes.end());
}

std::vector<std::array<int, 2>> PatchTree::meeting_pairs() const {
    std::vector<int> order(boxes_.size());
    std::iota(order.begin(), order.end(), 0);
    std::ranges::sort(order, {}, [&](int i) { return boxes_[i].low.x(); });
    std::vector<std::array<int, 2>> found;
    for (auto a = order.begin(); a != order.end(); ++a)
        for (auto b = a + 1; b != order.end() && boxes_[*b].low.x() <= boxes_[*a].high.x(); ++b)
            if (boxes_[*a].meets(boxes_[*b])) found.push_back({std::min(*a, *b), std::max(*a, *b)});
    std::ranges::sort(found);
    return found;
}

}  // namespace hepatica
