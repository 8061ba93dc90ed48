// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/potentials/pair_pads.h"

#include <algorithm>
#include <map>
#include <utility>

namespace hepatica {
namespace {

// How many nodes the first feature has, and all nodes. Those of each feature ascend, and of two
// edges the one with the lower nodes comes first, so that the same features have the same key on
// every surface.
using Key = std::pair<int, std::array<int, 4>>;

Key key_of(int in_first, std::array<int, 4> nodes) {
    const auto put_in_order = [&](int a, int b) {
        if (nodes[b] < nodes[a]) std::swap(nodes[a], nodes[b]);
    };
    put_in_order(2, 3);
    if (in_first == 1) {
        put_in_order(1, 2);
        put_in_order(2, 3);
        return {in_first, nodes};
    }
    put_in_order(0, 1);
    if (std::pair(nodes[2], nodes[3]) < std::pair(nodes[0], nodes[1]))
        nodes = {nodes[2], nodes[3], nodes[0], nodes[1]};
    return {in_first, nodes};
}

Key key_of(const FeaturePair& pair) {
    return key_of(pair.of_edges ? 2 : 1, pair.nodes);
}

Key key_of(const PairPad& pad) {
    return {pad.in_first, pad.nodes};
}

Key key_before(const FeaturePair& pair, std::span<const int> node_before) {
    std::array<int, 4> nodes = pair.nodes;
    for (int& v : nodes) v = node_before[v];
    return key_of(pair.of_edges ? 2 : 1, nodes);
}

}  // namespace

const PairPad* find_pad(std::span<const PairPad> pads, const FeaturePair& pair) {
    if (pads.empty()) return nullptr;
    const Key key = key_of(pair);
    const auto found =
        std::ranges::lower_bound(pads, key, {}, [](const PairPad& p) { return key_of(p); });
    return found != pads.end() && key_of(*found) == key ? &*found : nullptr;
}

bool are_pads(std::span<const PairPad> pads, int nodes) {
    const auto valid = [&](const PairPad& pad) {
        return (pad.in_first == 1 || pad.in_first == 2) &&
               std::ranges::all_of(pad.nodes, [&](int v) { return v >= 0 && v < nodes; }) &&
               key_of(pad) == key_of(pad.in_first, pad.nodes) && pad.pad_mm > 0.0 &&
               pad.pad_mm <= pad.most_mm && pad.share > 0.0 && pad.share <= 1.0;
    };
    const auto unordered = [](const PairPad& a, const PairPad& b) {
        return key_of(a) >= key_of(b);
    };
    return std::ranges::all_of(pads, valid) &&
           std::ranges::adjacent_find(pads, unordered) == pads.end();
}

std::vector<PairPad> pads_after_split(std::span<const PressedPair> before,
                                      std::span<const PressedPair> after,
                                      std::span<const int> node_before) {
    std::map<Key, const PressedPair*> was;
    for (const PressedPair& pair : before) was[key_of(pair.of)] = &pair;
    std::map<Key, double> area_mm2;  // of all that a pair is split into
    for (const PressedPair& pair : after)
        area_mm2[key_before(pair.of, node_before)] += pair.area_mm2;

    std::vector<PairPad> pads;
    for (const PressedPair& pair : after) {
        const Key now = key_of(pair.of), former = key_before(pair.of, node_before);
        PairPad pad{now.second, now.first, pair.gap_mm, pair.pad_mm, 1.0};
        if (const auto pressed = was.find(former); pressed != was.end()) {
            pad.pad_mm = std::min(pair.pad_mm, pressed->second->pad_mm);
            pad.share = std::min(1.0, pressed->second->area_mm2 / area_mm2[former]);
        }
        if (pad.pad_mm < pair.pad_mm || pad.share < 1.0) pads.push_back(pad);
    }
    std::ranges::sort(pads, {}, [](const PairPad& p) { return key_of(p); });
    return pads;
}

void add_new(std::span<const FeaturePair> pairs, std::span<const Vec3> positions_mm, double most_mm,
             std::vector<PairPad>& pads) {
    std::map<Key, PairPad> all;
    for (const PairPad& pad : pads) all.emplace(key_of(pad), pad);
    for (const FeaturePair& pair : pairs) {
        const double gap = distance_mm(pair, positions_mm);
        if (gap >= most_mm || gap <= 0.0) continue;
        const Key key = key_of(pair);
        all.emplace(key, PairPad{key.second, key.first, gap, most_mm, 1.0});
    }
    pads.clear();
    for (const auto& [key, pad] : all) pads.push_back(pad);
}

bool grow(PairPad& pad, double gap_mm) {
    if (gap_mm >= pad.pad_mm) {
        pad.pad_mm = std::min(gap_mm, pad.most_mm);
        pad.share = 1.0;
    }
    return gap_mm < pad.most_mm;
}

}  // namespace hepatica
