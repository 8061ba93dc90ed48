// SPDX-License-Identifier: GPL-3.0-or-later
// All pairs of features that may come near along a motion, and the last answer: what was found
// along a motion holds for every place and every way on it, too, so that the questions of one step,
// which go from place to place, cost an answer for each way. An answer costs searches only where
// patches have bent or moved against each other, see ClusterPairs.
#pragma once

#include <vector>

#include "core/contact/near_pairs.h"
#include "core/contact/neighbour_pairs.h"

namespace hepatica {

// Not thread-safe. What is found besides the nearest depends on the questions before; what is
// nearer than the reach is always among it.
class PairCover {
  public:
    // Keeps a reference. reach_mm and slack_mm > 0; see ClusterPairs.
    PairCover(const SurfaceFeatures& features, double reach_mm, double slack_mm);

    // The pairs that may come nearer than the reach while all vertices move straight from one place
    // to the other, in the order of the features: vertices and triangles, then edges. Until the
    // next question.
    const std::vector<FeaturePair>& along(std::span<const Vec3> from_mm,
                                          std::span<const Vec3> to_mm, const LeftOut& left_out);

    // To be called when what is left out changes.
    void forget() { known_ = false; }
    // Questions that the last answer did not hold for, and clusters that were searched: patches
    // with their neighbours, and two patches that share no node.
    int answers() const { return answers_; }
    int searches() const { return neighbours_.searches(); }
    int searches_of_strangers() const { return strangers_.searches(); }
    // Whether the last answer was found for this very motion.
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
    std::vector<Vec3> from_mm_, to_mm_;  // of the last question; empty: none
    std::vector<FeaturePair> near_;      // its answer, where it is known still
    std::vector<FeaturePair> unsorted_;  // scratch
    std::vector<int> begin_;             // scratch
    bool known_ = false;
    int answers_ = 0;
};

}  // namespace hepatica
