// SPDX-License-Identifier: GPL-3.0-or-later
// Pairs of features between a patch and some others, which are not searched for at each question:
// what turns and flies as one rigid piece keeps its distances. A cluster, all of these patches, is
// searched at one place, out to a reach; at another its vertices lie within e of that shape turned,
// by the quaternion q, and every distance is then at least the one searched for less 2 e. On a
// straight motion between two such places the shape shrinks besides: a mean of rotations about q_0
// and q_1 shortens lengths by q_0 . q_1 at most.
#pragma once

#include <optional>

#include "core/contact/patch_pair_search.h"
#include "core/contact/rigid_fit.h"

namespace hepatica {

class ClusterPairs {
  public:
    // The patch with these others, itself where it is to be searched within.
    ClusterPairs(const SurfaceFeatures& features, int patch, std::vector<int> others);

    // Adds all pairs that may come nearer than the reach; some that do not, too. `goes_on_mm`: the
    // motion begins where the last one ended, but for so much. Costs a pass over the vertices for
    // each end that is new, and a search where the cluster has bent by more than slack_mm.
    void add_along(const Sweep& sweep, double slack_mm, std::optional<double> goes_on_mm,
                   PatchPairSearch& search, std::vector<FeaturePair>& found);

    // So far.
    int searches() const { return searches_; }
    std::size_t bytes() const;

  private:
    struct Known {
        double apart_mm = 0.0;  // where it was searched
        FeaturePair pair;
    };
    double needed_mm(const Sweep& sweep, std::optional<double> goes_on_mm);
    void take_shape(std::span<const Vec3> positions_mm);
    void search_here(const Sweep& sweep, double slack_mm, PatchPairSearch& search);
    void add_all(const Sweep& sweep, PatchPairSearch& search,
                 std::vector<FeaturePair>& found) const;

    int patch_;
    std::vector<int> others_;
    std::vector<int> nodes_;
    std::vector<Vec3> shape_mm_;  // of the nodes, about their mean; empty: none yet
    std::vector<Known> pairs_;    // ascending
    double known_to_mm_ = -1.0;   // all that is nearer is among them
    RigidFit begins_, ends_;      // of the last motion
    int searches_ = 0;
};

}  // namespace hepatica
