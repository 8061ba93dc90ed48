// SPDX-License-Identifier: GPL-3.0-or-later
// Pairs of features that may be near, kept from one question to the next: a search along a motion
// holds for every place and way where each vertex keeps within a slack of that motion, all of them
// equally far along it. Whether a pair is left out of a question is decided by bounds on its
// distance, so that where nothing is near a question costs a pass over the vertices.
#pragma once

#include <vector>

#include "core/contact/near_pairs.h"

namespace hepatica {

// Not thread-safe. Answers may hold more pairs than the nearest, by the questions before; what is
// nearer than the reach is always among them.
class PairCover {
  public:
    // Keeps a reference. reach_mm and slack_mm > 0.
    PairCover(const SurfaceFeatures& features, double reach_mm, double slack_mm)
        : features_(features), search_(features), reach_mm_(reach_mm), slack_mm_(slack_mm) {}

    using LeftOut = std::function<bool(int patch, int other)>;

    // The pairs that may come nearer than the reach while all vertices move straight from one place
    // to the other.
    std::vector<FeaturePair> along(std::span<const Vec3> from_mm, std::span<const Vec3> to_mm,
                                   const LeftOut& left_out);

    // To be called when what is left out changes.
    void forget() { begin_mm_.clear(); }
    int searches() const { return searches_; }
    std::size_t bytes() const;

  private:
    double share_at(std::span<const Vec3> positions_mm) const;
    bool covers(std::span<const Vec3> positions_mm, double share);
    void search(std::span<const Vec3> from_mm, std::span<const Vec3> to_mm,
                const LeftOut& left_out);

    const SurfaceFeatures& features_;
    NearPairs search_;
    double reach_mm_, slack_mm_;
    std::vector<Vec3> begin_mm_, motion_mm_;  // of the search; empty: none yet
    double motion_squared_mm2_ = 0.0;
    std::vector<FeaturePair> pairs_;
    std::vector<double> beside_mm_;  // of each node: how far beside the motion, of this question
    int searches_ = 0;
};

}  // namespace hepatica
