// SPDX-License-Identifier: GPL-3.0-or-later
// Which features of patches that share no node may come near each other while all vertices move in
// straight lines. Patches are looked at first, by an observer who flies along with one of the two:
// what flies together meets little, and what flies past meets only what lies ahead. Of two that
// meet, the pairs are kept for as long as they move as one: what lies on another is searched once.
#pragma once

#include <memory>
#include <vector>

#include "core/contact/cluster_pairs.h"
#include "core/contact/patch_tree.h"

namespace hepatica {

// A search over one surface. Not thread-safe; runs in parallel. What is found besides the nearest
// depends on the questions before.
class NearPairs {
  public:
    // Keeps a reference. Two patches are searched anew where they have moved against each other by
    // more than slack_mm >= 0; boxes in the tree are some times wider than what moves in them, so
    // that small motions leave the tree as it is.
    NearPairs(const SurfaceFeatures& features, double slack_mm);
    ~NearPairs();

    // Adds all pairs that may come nearer than the reach, but for those left out; some that do not,
    // too. `goes_on_mm` as in ClusterPairs. Costs the boxes of all patches, and a pass over the
    // vertices of those that meet.
    void add_between_strangers(const Sweep& sweep, const LeftOut& left_out,
                               std::optional<double> goes_on_mm, std::vector<FeaturePair>& found);

    // Of two patches, so far.
    int searches() const;
    std::size_t bytes() const;

  private:
    // The vertices of a patch in their box at the beginning, all moved by `motion_mm` but for
    // `spread_mm`.
    struct Moving {
        Box box;
        Vec3 motion_mm = Vec3::Zero();
        double spread_mm = 0.0;

        Box swept(const Vec3& observer_mm) const;
    };
    // Two patches whose boxes in the tree meet.
    struct Strangers {
        std::array<int, 2> patches{};
        int asked = -1;                       // the question in which they met last
        std::unique_ptr<ClusterPairs> pairs;  // null: they have not met
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
