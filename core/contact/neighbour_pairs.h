// SPDX-License-Identifier: GPL-3.0-or-later
// Pairs of features within a patch and between patches that share a node. Most of them lie close
// together without ever touching, so they are not searched for at each question: what turns and
// flies as one rigid piece keeps its distances. A cluster, a patch with its neighbours, is searched
// at one place, out to a reach; at another its vertices lie within e of that shape turned, by the
// quaternion q, and every distance is then at least the one searched for less 2 e. On a straight
// motion between two such places the shape shrinks besides: a mean of rotations about q_0 and q_1
// shortens lengths by q_0 . q_1 at most.
#pragma once

#include <optional>

#include "core/contact/near_pairs.h"
#include "core/contact/rigid_fit.h"

namespace hepatica {

// Not thread-safe; runs in parallel.
class NeighbourPairs {
  public:
    // Keeps references. Clusters are searched anew where they have bent by more than slack_mm > 0.
    NeighbourPairs(const SurfaceFeatures& features, const NearPairs& search, double slack_mm);

    // Adds all pairs that may come nearer than the reach, which is the same for all questions;
    // some that do not, too. `goes_on_mm`: the motion begins where the last one ended, but for so
    // much. Costs a pass over the vertices of all clusters for each end that is new, and a search
    // of those that have bent.
    void add_along(const Sweep& sweep, std::optional<double> goes_on_mm,
                   std::vector<FeaturePair>& found);

    // Of clusters, so far.
    int searches() const;
    std::size_t bytes() const;

  private:
    struct Known {
        double apart_mm = 0.0;  // where it was searched
        FeaturePair pair;
    };
    struct Cluster {
        std::vector<int> patches;  // the first, and its neighbours of higher numbers
        std::vector<int> nodes;
        std::vector<Vec3> shape_mm;  // of the nodes, about their mean; empty: none yet
        std::vector<Known> pairs;    // ascending
        double known_to_mm = -1.0;   // all that is nearer is among them
        RigidFit begins, ends;       // of the last motion
        int searches = 0;
    };
    static double needed_mm(Cluster& cluster, const Sweep& sweep, std::optional<double> goes_on_mm);
    static void take_shape(Cluster& cluster, std::span<const Vec3> positions_mm);
    void search(Cluster& cluster, const Sweep& sweep) const;
    void add_along(Cluster& cluster, const Sweep& sweep, std::optional<double> goes_on_mm,
                   std::vector<FeaturePair>& found) const;
    void sweep_all(const Cluster& cluster, const Sweep& sweep,
                   std::vector<FeaturePair>& found) const;

    const NearPairs& search_;
    double slack_mm_;
    std::vector<Cluster> clusters_;
};

}  // namespace hepatica
