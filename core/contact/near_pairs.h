// SPDX-License-Identifier: GPL-3.0-or-later
// Which features of a surface may come near each other while all its vertices move in straight
// lines: vertices and triangles, edges and edges, that share no vertex. Decided by boxes around
// what patches, triangles and features sweep, seen by an observer who flies along with one of the
// two patches: what flies together meets little, and what flies past meets only what lies ahead.
#pragma once

#include <vector>

#include "core/contact/patch_tree.h"
#include "core/contact/surface_features.h"

namespace hepatica {

// All vertices move straight from one place to another, and what comes nearer than the reach is
// asked for.
struct Sweep {
    std::span<const Vec3> from_mm, to_mm;
    double reach_mm = 0.0;

    bool stands() const { return from_mm.data() == to_mm.data(); }
};

// A search over one surface. Not thread-safe; runs in parallel. The same motion gives the same
// pairs, in an order that depends on the motions before.
class NearPairs {
  public:
    // Keeps a reference. Boxes in the tree are so much wider than what moves in them, so that small
    // motions leave the tree as it is.
    NearPairs(const SurfaceFeatures& features, double margin_mm)
        : features_(features), margin_mm_(margin_mm) {}
    ~NearPairs();

    // Adds all pairs that may come nearer than the reach, of patches that share no node; some that
    // do not, too. Costs the boxes of all patches and the triangles of those that meet.
    void add_between_strangers(const Sweep& sweep, const LeftOut& left_out,
                               std::vector<FeaturePair>& found);

    // The same of one pair of patches or of one patch, all of which count. Thread-safe.
    void add_pairs_of(int patch, int other, const Sweep& sweep,
                      std::vector<FeaturePair>& found) const;

  private:
    // The vertices of a patch in their box at the beginning, all moved by `motion_mm` but for
    // `spread_mm`.
    struct Moving {
        Box box;
        Vec3 motion_mm = Vec3::Zero();
        double spread_mm = 0.0;

        Box swept(const Vec3& observer_mm) const;
    };
    Moving moving(int patch, const Sweep& sweep) const;
    void find_strangers(const Sweep& sweep);
    bool may_meet(int patch, int other, double reach_mm) const;
    void add_pairs_of(int patch, int other, const Sweep& sweep, const Vec3& observer_mm,
                      std::vector<FeaturePair>& found) const;

    const SurfaceFeatures& features_;
    double margin_mm_;
    std::unique_ptr<PatchTree> tree_;
    std::vector<Box> boxes_;                     // in the tree
    std::vector<std::array<int, 2>> strangers_;  // whose boxes meet
    std::vector<Moving> patches_;
};

}  // namespace hepatica
