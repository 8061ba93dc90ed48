// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/overlaps.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/contact/point_in_surface.h"

namespace hepatica {
namespace {

std::array<int, 2> ordered(int a, int b) {
    return {std::min(a, b), std::max(a, b)};
}

void each_once(Overlaps::Pairs& pairs) {
    std::ranges::sort(pairs);
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
}

}  // namespace

bool Overlaps::nearer_than(double gap_mm, int patch, int other,
                           std::span<const Vec3> positions_mm) const {
    const SurfacePatches& surface = features_.surface();
    const auto near = [&](int a, int b) {
        const Triangle first = corners_of(surface.triangles()[a], positions_mm);
        const Triangle second = corners_of(surface.triangles()[b], positions_mm);
        Box wide = box_around(first);
        wide.grow(gap_mm);
        return wide.meets(box_around(second)) &&
               squared_distance_mm2(first, second) <= gap_mm * gap_mm;
    };
    const auto before = near_.find({patch, other});
    if (before != near_.end() && near(before->second[0], before->second[1])) return true;
    for (const int a : surface.triangles_of(patch))
        for (const int b : surface.triangles_of(other))
            if (near(a, b)) {
                near_[{patch, other}] = {a, b};
                return true;
            }
    return false;
}

bool Overlaps::within(const Vec3& point, int piece, std::span<const Box> boxes,
                      std::span<const Vec3> positions_mm) const {
    return lies_within(point, features_.surface(), features_.patches_of_piece(piece), boxes,
                       positions_mm);
}

bool Overlaps::lies_in(int patch, int piece, std::span<const Box> boxes,
                       std::span<const Vec3> positions_mm) const {
    const bool holds = features_.kind_of_piece(piece) == SurfaceKind::shell;
    const auto in = [&](int v) {
        return within(positions_mm[v], piece, boxes, positions_mm) != holds;
    };
    const auto before = within_.find({patch, piece});
    if (before != within_.end() && in(before->second)) return true;
    const auto vertices = features_.surface().vertices_of(patch);
    const auto found = std::ranges::find_if(vertices, in);
    if (found == vertices.end()) return false;
    within_[{patch, piece}] = *found;
    return true;
}

bool Overlaps::may_lie_in(int patch, int piece) const {
    if (!features_.beside_obstacles()) return piece != features_.piece_of_patch(patch);
    return features_.kind_of_patch(patch) == SurfaceKind::moving &&
           features_.kind_of_piece(piece) != SurfaceKind::moving;
}

void Overlaps::find(std::span<const Vec3> positions_mm, double touch_mm, const Overlaps* at_rest) {
    touching_.clear();
    buried_.clear();
    if (features_.pieces() < 2) return;
    const std::vector<Box> boxes = boxes_of_patches(features_.surface(), positions_mm);
    std::vector<Box> pieces(features_.pieces());
    for (std::size_t p = 0; p < boxes.size(); ++p) {
        Box& piece = pieces[features_.piece_of_patch(static_cast<int>(p))];
        piece.add(boxes[p].low);
        piece.add(boxes[p].high);
    }
    const int patches = static_cast<int>(boxes.size());
    for (int p = 0; p < patches; ++p) {
        Box wide = boxes[p];
        wide.grow(touch_mm);
        for (int q = p + 1; q < patches; ++q)
            if (features_.piece_of_patch(p) != features_.piece_of_patch(q) &&
                features_.may_meet(p, q) && wide.meets(boxes[q]) &&
                nearer_than(touch_mm, p, q, positions_mm))
                touching_.push_back({p, q});
        for (int piece = 0; piece < features_.pieces(); ++piece)
            if (may_lie_in(p, piece) && (for_good(piece) || pieces[piece].meets(boxes[p])) &&
                lies_in(p, piece, boxes, positions_mm))
                buried_.push_back({p, piece});
    }
    if (at_rest == nullptr) return;
    std::ranges::copy_if(at_rest->buried_, std::back_inserter(buried_),
                         [&](const auto& buried) { return for_good(buried[1]); });
    each_once(buried_);
}

// A pair that separated on the wrong side: the patch is left out with the whole piece, or obstacle,
// that it slipped into, from then on.
bool Overlaps::slipped_in(const std::array<int, 2>& touching, std::span<const Box> boxes,
                          std::span<const Vec3> positions_mm, Pairs& buried) const {
    for (const auto& [patch, other] : {touching, std::array<int, 2>{touching[1], touching[0]}}) {
        const int piece = features_.piece_of_patch(other);
        if (!may_lie_in(patch, piece) || !lies_in(patch, piece, boxes, positions_mm)) continue;
        buried.push_back({patch, piece});
        return true;
    }
    return false;
}

bool Overlaps::let_go(std::span<const Vec3> positions_mm, double reach_mm) {
    if (touching_.empty() &&
        std::ranges::all_of(buried_, [&](const auto& pair) { return for_good(pair[1]); }))
        return false;
    const std::vector<Box> boxes = boxes_of_patches(features_.surface(), positions_mm);
    const auto near = [&](int p, int q) {
        Box wide = boxes[p];
        wide.grow(reach_mm);
        return wide.meets(boxes[q]) && nearer_than(reach_mm, p, q, positions_mm);
    };
    const std::size_t before = touching_.size() + buried_.size();
    Pairs still, come_near;
    for (const auto& [patch, piece] : buried_) {
        if (for_good(piece) || lies_in(patch, piece, boxes, positions_mm)) {
            still.push_back({patch, piece});
            continue;
        }
        // It has come out; nearby patches of the piece are left out individually.
        for (int q = 0; q < static_cast<int>(boxes.size()); ++q)
            if (features_.piece_of_patch(q) == piece && near(patch, q))
                come_near.push_back(ordered(patch, q));
    }
    const bool freed = still.size() < buried_.size();
    bool slipped = false;
    std::erase_if(touching_, [&](const auto& pair) {
        if (near(pair[0], pair[1])) return false;
        slipped |= slipped_in(pair, boxes, positions_mm, still);
        return true;
    });
    buried_ = std::move(still);
    if (slipped) each_once(buried_);
    touching_.insert(touching_.end(), come_near.begin(), come_near.end());
    each_once(touching_);
    return freed || slipped || touching_.size() + buried_.size() != before;
}

bool Overlaps::left_out(int patch, int other) const {
    if (!any()) return false;
    const int first = features_.piece_of_patch(patch), second = features_.piece_of_patch(other);
    if (first == second) return false;
    return std::ranges::binary_search(touching_, ordered(patch, other)) ||
           std::ranges::binary_search(buried_, std::array<int, 2>{patch, second}) ||
           std::ranges::binary_search(buried_, std::array<int, 2>{other, first});
}

bool Overlaps::set(const Pairs& touching, const Pairs& buried) {
    const int patches = static_cast<int>(features_.surface().size());
    const auto all_below = [](const Pairs& pairs, int first, int second) {
        return std::ranges::is_sorted(pairs) && std::ranges::all_of(pairs, [&](const auto& pair) {
                   return pair[0] >= 0 && pair[0] < first && pair[1] >= 0 && pair[1] < second;
               });
    };
    if (!all_below(touching, patches, patches) || !all_below(buried, patches, features_.pieces()))
        return false;
    touching_ = touching;
    buried_ = buried;
    return true;
}

}  // namespace hepatica
