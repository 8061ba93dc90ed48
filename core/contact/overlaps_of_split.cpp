// SPDX-License-Identifier: GPL-3.0-or-later
// hepatica::Overlaps: which overlaps a tear keeps and which it adds.
#include <algorithm>
#include <map>

#include "core/contact/overlaps.h"
#include "core/contact/point_in_surface.h"

namespace hepatica {
namespace {

constexpr int unknown = -1;

std::array<int, 3> ascending(std::array<int, 3> corners) {
    std::ranges::sort(corners);
    return corners;
}

template <class T>
void each_once(std::vector<T>& some) {
    std::ranges::sort(some);
    some.erase(std::unique(some.begin(), some.end()), some.end());
}

bool in_common(const std::vector<int>& a, const std::vector<int>& b) {
    return std::ranges::any_of(a, [&](int v) { return std::ranges::binary_search(b, v); });
}

// Where a patch of a torn surface comes from.
struct Origin {
    std::vector<int> patches;   // former patches with triangles in common, ascending
    std::vector<int> split_at;  // former numbers of its vertices that were split, ascending
    std::vector<int> bare;      // its triangles that were inside before
};

std::vector<Origin> origins_of(const SurfaceFeatures& now, const SurfaceFeatures& before,
                               std::span<const int> node_before) {
    std::map<std::array<int, 3>, int> patch_before;
    const auto& old = before.surface().triangles();
    for (std::size_t t = 0; t < old.size(); ++t)
        patch_before[ascending(old[t])] = before.patch_of(static_cast<int>(t));
    std::vector<int> children(node_before.size(), 0);
    for (const int v : node_before) ++children[v];
    std::vector<Origin> origins(now.surface().size());
    for (std::size_t p = 0; p < origins.size(); ++p) {
        for (const int t : now.surface().triangles_of(p)) {
            std::array<int, 3> corners = now.surface().triangles()[t];
            for (int& v : corners) v = node_before[v];
            const auto found = patch_before.find(ascending(corners));
            if (found == patch_before.end())
                origins[p].bare.push_back(t);
            else
                origins[p].patches.push_back(found->second);
        }
        for (const int v : now.surface().vertices_of(p))
            if (children[node_before[v]] > 1) origins[p].split_at.push_back(node_before[v]);
        each_once(origins[p].patches);
        each_once(origins[p].split_at);
    }
    return origins;
}

// The former piece of each piece; a tear divides pieces and never joins them. A piece whose surface
// was all inside belongs to the piece of its vertices.
std::vector<int> pieces_before(const SurfaceFeatures& now, const SurfaceFeatures& before,
                               const std::vector<Origin>& origins,
                               std::span<const int> node_before) {
    std::vector<int> piece(now.pieces(), unknown);
    std::vector<int> of_node(node_before.size(), unknown);
    for (bool found = true; found;) {
        found = false;
        for (std::size_t p = 0; p < origins.size(); ++p) {
            int& mine = piece[now.piece_of_patch(static_cast<int>(p))];
            if (mine == unknown && !origins[p].patches.empty())
                mine = before.piece_of_patch(origins[p].patches.front());
            for (const int v : now.surface().vertices_of(p)) {
                int& there = of_node[node_before[v]];
                if ((mine == unknown) == (there == unknown)) continue;
                (mine == unknown ? mine : there) = mine == unknown ? there : mine;
                found = true;
            }
        }
    }
    return piece;
}

bool holds(const Overlaps::Pairs& pairs, int a, int b) {
    return std::ranges::binary_search(pairs, std::array<int, 2>{a, b});
}

bool touched(const Overlaps::Pairs& touching, const Origin& a, const Origin& b) {
    for (const int p : a.patches)
        for (const int q : b.patches)
            if (holds(touching, std::min(p, q), std::max(p, q))) return true;
    return false;
}

bool any_cross(std::span<const int> some, std::span<const int> others,
               const SurfacePatches& surface, std::span<const Vec3> positions_mm) {
    for (const int a : some) {
        const Triangle first = corners_of(surface.triangles()[a], positions_mm);
        const Box box = box_around(first);
        for (const int b : others) {
            const Triangle second = corners_of(surface.triangles()[b], positions_mm);
            if (box.meets(box_around(second)) && squared_distance_mm2(first, second) == 0.0)
                return true;
        }
    }
    return false;
}

}  // namespace

void Overlaps::follow_split(const OverlapsBefore& before, std::span<const int> node_before,
                            std::span<const Vec3> positions_mm, double reach_mm,
                            const Pairs* parted) {
    touching_.clear();
    buried_.clear();
    if (features_.pieces() < 2) return;
    const SurfacePatches& surface = features_.surface();
    const std::vector<Origin> origins = origins_of(features_, before.features, node_before);
    const std::vector<int> old_piece =
        pieces_before(features_, before.features, origins, node_before);
    const std::vector<Box> boxes = boxes_of_patches(features_.surface(), positions_mm);
    const auto piece_of = [&](int patch) { return features_.piece_of_patch(patch); };
    const auto of_one_piece = [&](int p, int q) {
        return old_piece[piece_of(p)] == old_piece[piece_of(q)];
    };
    const auto bare_cross = [&](int p, int q) {
        return any_cross(origins[p].bare, surface.triangles_of(q), surface, positions_mm) ||
               any_cross(origins[q].bare, surface.triangles_of(p), surface, positions_mm);
    };
    const auto was_buried = [&](int patch, int piece) {
        return std::ranges::any_of(origins[patch].patches, [&](int former) {
            return holds(before.buried, former, old_piece[piece]);
        });
    };
    // A part of a patch that lay in a piece may pass through its wall without a vertex inside: it
    // stays left out while it is near.
    const auto were_left_out = [&](int p, int q) {
        return touched(before.touching, origins[p], origins[q]) || was_buried(p, piece_of(q)) ||
               was_buried(q, piece_of(p));
    };
    const auto overlap = [&](int p, int q) {
        if (!of_one_piece(p, q))
            return bare_cross(p, q) ||
                   (were_left_out(p, q) && nearer_than(reach_mm, p, q, positions_mm));
        return parted == nullptr && in_common(origins[p].split_at, origins[q].split_at) &&
               nearer_than(reach_mm, p, q, positions_mm);
    };
    const int patches = static_cast<int>(boxes.size());
    for (int p = 0; p < patches; ++p) {
        Box wide = boxes[p];
        wide.grow(reach_mm);
        for (int q = p + 1; q < patches; ++q)
            if (piece_of(p) != piece_of(q) && features_.may_meet(p, q) && wide.meets(boxes[q]) &&
                overlap(p, q))
                touching_.push_back({p, q});
        for (int piece = 0; piece < features_.pieces(); ++piece)
            if (may_lie_in(p, piece) && old_piece[piece] != old_piece[piece_of(p)] &&
                (!origins[p].bare.empty() || was_buried(p, piece)) &&
                ((for_good(piece) && was_buried(p, piece)) ||
                 lies_in(p, piece, boxes, positions_mm)))
                buried_.push_back({p, piece});
    }
    if (parted == nullptr) return;
    touching_.insert(touching_.end(), parted->begin(), parted->end());
    each_once(touching_);
}

}  // namespace hepatica
