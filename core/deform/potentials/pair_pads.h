// SPDX-License-Identifier: GPL-3.0-or-later
// Pads between surfaces across a split. A split lays faces bare and changes the areas of the
// features beside them, so that pads would store energy that nothing has done work for. Instead, a
// pair that was pressed keeps its pad and its force, which the pairs that it is split into share by
// area; a pair that is new begins with a pad as thin as its gap, where it stores nothing. Such a
// pad grows with the gap, at no cost, until it is the one that it would be otherwise.
#pragma once

#include <span>
#include <vector>

#include "core/contact/surface_features.h"
#include "core/deform/potentials/self_load.h"

namespace hepatica {

// A pair of features in its pad.
struct PressedPair {
    FeaturePair of;
    double pad_mm = 0.0;    // > gap_mm
    double area_mm2 = 0.0;  // > 0
    double gap_mm = 0.0;
};

// Null where the pair's pad is what it would be without a split. `pads` ascend.
const PairPad* find_pad(std::span<const PairPad> pads, const FeaturePair& pair);

// Whether they ascend and lie within what is valid, for nodes numbered from 0 below `nodes`.
bool are_pads(std::span<const PairPad> pads, int nodes);

// The pads after a split, ascending: from the pairs that were pressed before it, and from those
// that would be after it if nothing were kept. `node_before` is the former node of each node; no
// position has changed.
std::vector<PairPad> pads_after_split(std::span<const PressedPair> before,
                                      std::span<const PressedPair> after,
                                      std::span<const int> node_before);

// Adds pairs that begin to touch, with a pad as thin as their gap; a pair that is there already
// stays as it is; one that lies apart by most_mm needs none, and one without a gap gets none.
void add_new(std::span<const FeaturePair> pairs, std::span<const Vec3> positions_mm, double most_mm,
             std::vector<PairPad>& pads);

// Lets a pad that stores nothing at this gap grow to it, with all of its area; false where it is
// what it would be otherwise.
bool grow(PairPad& pad, double gap_mm);

}  // namespace hepatica
