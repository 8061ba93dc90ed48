// SPDX-License-Identifier: GPL-3.0-or-later
// Pairs of features within a patch and between patches that share a node. Most of them are close
// without ever touching, so they are kept: ClusterPairs of every patch and its neighbours.
#pragma once

#include "core/contact/cluster_pairs.h"

namespace hepatica {

// Not thread-safe; runs in parallel.
class NeighbourPairs {
  public:
    // Keeps a reference. A cluster is searched again when it has deformed by more than slack_mm >
    // 0.
    NeighbourPairs(const SurfaceFeatures& features, double slack_mm);

    // ClusterPairs::add_along for all clusters.
    void add_along(const Sweep& sweep, std::optional<double> goes_on_mm,
                   std::vector<FeaturePair>& found);

    // Number of searches of clusters so far.
    int searches() const;
    std::size_t bytes() const;

  private:
    const SurfaceFeatures& features_;
    double slack_mm_;
    std::vector<ClusterPairs> clusters_;
};

}  // namespace hepatica
