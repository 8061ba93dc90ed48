// SPDX-License-Identifier: GPL-3.0-or-later
// The two sides of a tear. A split leaves the parts of a vertex, twins, at one place, with faces
// that lie on each other: no distance says on which side they are. Pairs of features around twins
// do not count until the twins have come apart, which they have where
//   each is outside of the surface around the other, by the normal of the feature there that is
//   nearest, weighted by angle (Baerentzen and Aanaes 2005), and
//   no feature around the one is nearer than a least gap to a feature around the other, and no
//   triangle crosses one of the other's, but for pairs that other twins hold back.
// From then on they count, so that a flap does not pass through the bed that it was torn from.
// Where a split parts two pieces, the patches around their twins are left to Overlaps.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/contact/surface_features.h"

namespace hepatica {

// Not thread-safe.
class TornSides {
  public:
    // Of one piece; each twin in ascending order, and all of them.
    using Twins = std::vector<std::array<int, 2>>;
    // Of patches, likewise.
    using PatchPairs = std::vector<std::array<int, 2>>;

    // Keeps a reference.
    explicit TornSides(const SurfaceFeatures& features) : features_(features) {}

    // After a split: children of twins that lay on each other still do, and so do vertices that
    // were one before. `node_before` is the former node of each node, `node_of_whole` the one
    // before the first tear. Returns the patches of two pieces around such twins, which may cross.
    PatchPairs follow_split(const Twins& before, std::span<const int> node_before,
                            std::vector<int> node_of_whole);
    // All twins lie on each other, but for those that have come apart at these positions.
    void find(std::span<const Vec3> positions_mm, double least_gap_mm);
    // Lets twins go that have come apart. Returns the pairs of features that count from now on.
    std::vector<FeaturePair> let_go(std::span<const Vec3> positions_mm, double least_gap_mm);

    // Whether the pair does not count.
    bool lie_on_each_other(const FeaturePair& pair) const;
    // Whether the features shared a vertex before the first tear.
    bool shared_a_vertex(const FeaturePair& pair) const;

    // For checkpoints. set() returns false and changes nothing where these are no twins.
    const Twins& lying() const { return lying_; }
    bool set(const Twins& lying);

  private:
    bool is_lying(int node, int other) const;
    bool of_one_piece(const std::array<int, 2>& twins) const;
    PatchPairs give_up_parted();
    bool have_come_apart(const std::array<int, 2>& twins, std::span<const Vec3> positions_mm,
                         double least_gap_mm) const;
    bool any_cross(const std::array<int, 2>& twins, std::span<const Vec3> positions_mm) const;
    bool outside(int node, int twin, std::span<const Vec3> positions_mm) const;
    // The pairs of features around twins that no others hold back.
    std::vector<FeaturePair> pairs_of(const std::array<int, 2>& twins) const;
    void find_triangles();

    const SurfaceFeatures& features_;
    std::vector<int> node_of_whole_;  // empty: not torn
    Twins lying_;
    std::vector<std::vector<int>> triangles_of_node_;  // of twins; empty for others
};

}  // namespace hepatica
