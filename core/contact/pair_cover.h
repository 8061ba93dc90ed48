// SPDX-License-Identifier: GPL-3.0-or-later
// All pairs of features that may come near along a motion, with a cache of the last answer: the
// pairs found for a motion also hold for every position and every part of it, so that the queries
// of one step cost one answer per motion. An answer costs searches only where patches have deformed
// or moved relative to each other, see ClusterPairs.
#pragma once

#include <vector>

#include "core/contact/near_pairs.h"
#include "core/contact/neighbour_pairs.h"

namespace hepatica {

// Not thread-safe. Every pair nearer than the reach is found; which others are depends on earlier
// queries.
class PairCover {
  public:
    // Keeps a reference. reach_mm and slack_mm > 0; see ClusterPairs.
    PairCover(const SurfaceFeatures& features, double reach_mm, double slack_mm);

    // The pairs that may come nearer than the reach while all vertices move straight from one
    // position to the other, in the order of the features: vertices and triangles, then edges.
    // Valid until the next query.
    const std::vector<FeaturePair>& along(std::span<const Vec3> from_mm,
                                          std::span<const Vec3> to_mm, const LeftOut& left_out);

    // To be called when what is left out changes.
    void forget() { known_ = false; }
    // Number of queries that the cached answer did not cover, and of searched clusters: patches
    // with their neighbours, and pairs of patches without a common node.
    int answers() const { return answers_; }
    int searches() const { return neighbours_.searches(); }
    int searches_of_strangers() const { return strangers_.searches(); }
    // Whether the last answer was found for exactly this motion.
    bool is_of(std::span<const Vec3> from_mm, std::span<const Vec3> to_mm) const;
    std::size_t bytes() const;

  private:
    bool on_the_way(std::span<const Vec3> positions_mm) const;
    bool at_its_end(std::span<const Vec3> positions_mm) const;
    bool near_all(std::span<const Vec3> positions_mm, double share) const;
    void sort_by_feature(std::size_t nodes);

    const SurfaceFeatures& features_;
    NearPairs strangers_;
    NeighbourPairs neighbours_;
    double reach_mm_, same_mm_;
    std::vector<Vec3> from_mm_, to_mm_;  // of the last query; empty: none
    std::vector<FeaturePair> near_;      // its answer, valid if known_
    std::vector<FeaturePair> unsorted_;  // scratch
    std::vector<int> begin_;             // scratch
    bool known_ = false;
    int answers_ = 0;
};

}  // namespace hepatica
