// SPDX-License-Identifier: GPL-3.0-or-later
// Which features of two patches, or of one, may come near each other while all vertices move in
// straight lines: vertices and triangles, or two edges, without a common vertex. Decided by the
// boxes that they sweep in the frame of one of the two patches.
#pragma once

#include <vector>

#include "core/contact/surface_features.h"

namespace hepatica {

// All vertices move straight from one position to another; wanted are the pairs that come nearer
// than the reach.
struct Sweep {
    std::span<const Vec3> from_mm, to_mm;
    double reach_mm = 0.0;

    bool stands() const { return from_mm.data() == to_mm.data(); }
};

// Keeps a reference and scratch memory: use one per thread.
class PatchPairSearch {
  public:
    explicit PatchPairSearch(const SurfaceFeatures& features) : features_(features) {}

    // Appends all pairs that may come nearer than the reach, each once, and some others.
    void add_pairs_of(int patch, int other, const Sweep& sweep, std::vector<FeaturePair>& found);

  private:
    // Four numbers are compared at once; the fourth is 0.
    struct Swept {
        Eigen::Array4d low, high;

        void add(const Eigen::Array4d& point) {
            low = low.min(point);
            high = high.max(point);
        }
        void grow(double margin) {
            low.head<3>() -= margin;
            high.head<3>() += margin;
        }
        bool meets(const Swept& other) const {
            return (low - other.high).max(other.low - high).maxCoeff() <= 0.0;
        }
    };
    struct Feature {
        int number = 0;
        Swept box;
    };
    // The features of a patch that come near a box.
    struct Part {
        std::vector<Feature> nodes, edges, triangles;
    };

    template <class Nodes>
    Swept swept(const Nodes& nodes) const;
    void list(int patch, const Swept& near, double margin_mm, Part& part) const;
    void add_vertices(const Part& of_vertices, const Part& of_triangles,
                      std::vector<FeaturePair>& found) const;
    void add_edges(bool within, std::vector<FeaturePair>& found) const;

    const SurfaceFeatures& features_;
    Sweep sweep_;
    Eigen::Array4d observer_mm_;
    Part first_, second_;  // boxes of the first are grown by the reach
};

}  // namespace hepatica
