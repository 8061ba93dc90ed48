// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/patch_tree.h"

#include <BulletCollision/BroadphaseCollision/btDbvt.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace hepatica {
namespace {

btVector3 below(const Vec3& x) {
    const auto down = [](double value) {
        return std::nextafter(static_cast<btScalar>(value), -INFINITY);
    };
    return {down(x.x()), down(x.y()), down(x.z())};
}

btVector3 above(const Vec3& x) {
    const auto up = [](double value) {
        return std::nextafter(static_cast<btScalar>(value), INFINITY);
    };
    return {up(x.x()), up(x.y()), up(x.z())};
}

btDbvtVolume volume_around(const Box& box) {
    return btDbvtVolume::FromMM(below(box.low), above(box.high));
}

int patch_of(const btDbvtNode* leaf) {
    return static_cast<int>(reinterpret_cast<std::intptr_t>(leaf->data));
}

struct MeetingPairs final : btDbvt::ICollide {
    std::vector<std::array<int, 2>> pairs;
    void Process(const btDbvtNode* first, const btDbvtNode* second) override {
        const int a = patch_of(first), b = patch_of(second);
        if (a != b) pairs.push_back({std::min(a, b), std::max(a, b)});
    }
};

}  // namespace

struct PatchTree::Implementation {
    btDbvt tree;
    std::vector<btDbvtNode*> leaves;
};

PatchTree::PatchTree(std::span<const Box> boxes)
    : tree_(std::make_unique<Implementation>()), boxes_(boxes.begin(), boxes.end()) {
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        void* number = reinterpret_cast<void*>(static_cast<std::intptr_t>(i));
        tree_->leaves.push_back(tree_->tree.insert(volume_around(boxes[i]), number));
    }
}

PatchTree::~PatchTree() = default;

void PatchTree::refit(std::span<const Box> boxes) {
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        if (boxes[i].low == boxes_[i].low && boxes[i].high == boxes_[i].high) continue;
        boxes_[i] = boxes[i];
        btDbvtVolume volume = volume_around(boxes[i]);
        tree_->tree.update(tree_->leaves[i], volume);
    }
}

std::vector<std::array<int, 2>> PatchTree::meeting_pairs() const {
    MeetingPairs found;
    const btDbvtNode* root = tree_->tree.m_root;
    tree_->tree.collideTT(root, root, found);
    auto& pairs = found.pairs;
    std::erase_if(pairs, [&](const auto& pair) { return !boxes_[pair[0]].meets(boxes_[pair[1]]); });
    std::ranges::sort(pairs);
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    return pairs;
}

}  // namespace hepatica
