// SPDX-License-Identifier: GPL-3.0-or-later
// Which features of patches without a common node may come near each other while all vertices move
// in straight lines. Patches are tested first, in the frame of one of the two: patches that fly
// together meet few others, and a passing patch meets only what is ahead of it. The pairs of two
// patches that meet are kept while they move as one rigid body, so that resting contacts are
// searched once.
#pragma once

#include <memory>
#include <vector>

#include "core/contact/cluster_pairs.h"
#include "core/contact/patch_tree.h"

namespace hepatica {

// A search over one surface. Not thread-safe; runs in parallel. Pairs beyond the reach may be found
// too; which ones depends on earlier queries.
class NearPairs {
  public:
    // Keeps a reference. Two patches are searched again when they have moved relative to each other
    // by more than slack_mm >= 0; boxes in the tree have a margin of several slacks, so that small
    // motions leave the tree unchanged.
    NearPairs(const SurfaceFeatures& features, double slack_mm);
    ~NearPairs();

    // Appends all pairs that may come nearer than the reach, except those left out, and some
    // others. `goes_on_mm` as in ClusterPairs. Costs the boxes of all patches and a pass over the
    // vertices of those that meet.
    void add_between_strangers(const Sweep& sweep, const LeftOut& left_out,
                               std::optional<double> goes_on_mm, std::vector<FeaturePair>& found);

    // Number of searches of two patches so far.
    int searches() const;
    std::size_t bytes() const;

  private:
    // The vertices of a patch: their box at the start; all move by `motion_mm` up to `spread_mm`.
    struct Moving {
        Box box;
        Vec3 motion_mm = Vec3::Zero();
        double spread_mm = 0.0;

        Box swept(const Vec3& observer_mm) const;
    };
    // Two patches whose boxes in the tree meet.
    struct Strangers {
        std::array<int, 2> patches{};
        int asked = -1;                       // the last query in which they met
        std::unique_ptr<ClusterPairs> pairs;  // null: they have not met yet
    };
    Moving moving(int patch, const Sweep& sweep) const;
    void find_strangers(const Sweep& sweep);
    void keep_strangers(const std::vector<std::array<int, 2>>& meeting);
    bool may_meet(const Strangers& two, double reach_mm) const;
    void add_pairs_of(Strangers& two, const Sweep& sweep, const LeftOut& left_out,
                      std::optional<double> goes_on_mm, PatchPairSearch& search,
                      std::vector<FeaturePair>& found) const;

    const SurfaceFeatures& features_;
    double slack_mm_;
    std::unique_ptr<PatchTree> tree_;
    std::vector<Box> boxes_;  // in the tree
    std::vector<Strangers> strangers_;
    std::vector<Moving> patches_;
    int questions_ = 0;
};

}  // namespace hepatica
