// SPDX-License-Identifier: GPL-3.0-or-later
// Pairs of features within a patch and between patches that share a node. Most of them lie close
// together without ever touching, so they are kept: ClusterPairs of every patch and its neighbours.
#pragma once

#include "core/contact/cluster_pairs.h"

namespace hepatica {

// Not thread-safe; runs in parallel.
class NeighbourPairs {
  public:
    // Keeps a reference. Clusters are searched anew where they have bent by more than slack_mm > 0.
    NeighbourPairs(const SurfaceFeatures& features, double slack_mm);

    // As ClusterPairs, of all.
    void add_along(const Sweep& sweep, std::optional<double> goes_on_mm,
                   std::vector<FeaturePair>& found);

    // Of clusters, so far.
    int searches() const;
    std::size_t bytes() const;

  private:
    const SurfaceFeatures& features_;
    double slack_mm_;
    std::vector<ClusterPairs> clusters_;
};

}  // namespace hepatica
