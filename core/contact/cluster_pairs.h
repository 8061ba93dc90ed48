// SPDX-License-Identifier: GPL-3.0-or-later
// Pairs of features between a patch and some others that are not searched for again at each query,
// because a piece that moves as one rigid body keeps its distances. A cluster, all of these patches
// together, is searched once, at one shape and out to a reach. If later its vertices are within e
// of that shape rotated by a quaternion q, every distance is at least the searched one minus 2 e.
// During a straight motion between two such positions the shape also shrinks: a mean of rotations
// by q_0 and q_1 shortens lengths at most by the factor q_0 . q_1.
#pragma once

#include <optional>

#include "core/contact/patch_pair_search.h"
#include "core/contact/rigid_fit.h"

namespace hepatica {

class ClusterPairs {
  public:
    // The patch and the others; these include the patch itself if pairs within it are wanted.
    ClusterPairs(const SurfaceFeatures& features, int patch, std::vector<int> others);

    // Appends all pairs that may come nearer than the reach, and some others. `goes_on_mm`: the
    // motion starts where the last one ended, up to this distance. Costs a pass over the vertices
    // for each new end of the motion, and a search where the cluster has deformed by more than
    // slack_mm.
    void add_along(const Sweep& sweep, double slack_mm, std::optional<double> goes_on_mm,
                   PatchPairSearch& search, std::vector<FeaturePair>& found);

    // Number of searches so far.
    int searches() const { return searches_; }
    std::size_t bytes() const;

  private:
    struct Known {
        double apart_mm = 0.0;  // when it was searched
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
    std::vector<Vec3> shape_mm_;  // of the nodes, relative to their mean; empty: none yet
    std::vector<Known> pairs_;    // ascending
    double known_to_mm_ = -1.0;   // all pairs up to this distance are known
    RigidFit begins_, ends_;      // of the last motion
    int searches_ = 0;
};

}  // namespace hepatica
