// SPDX-License-Identifier: GPL-3.0-or-later
// Which features of a surface may come near each other while all its vertices move in straight
// lines: vertices and triangles, edges and edges, that share no vertex. What moves alike comes no
// nearer: bounds are on relative motion, so that a vessel that flies as a whole meets little.
#pragma once

#include <functional>
#include <vector>

#include "core/contact/patch_tree.h"
#include "core/contact/surface_features.h"

namespace hepatica {

struct FeaturePair {
    bool of_edges = false;       // else a vertex and a triangle
    int first = 0, second = 0;   // the vertex and the triangle, or the edges, first < second
    std::array<int, 4> nodes{};  // of the first, then of the second
    double apart_mm = 0.0;       // at the beginning of the motion
    double approach_mm = 0.0;    // at most so much nearer along it
};

// A search over one surface. Not thread-safe; runs in parallel. The same motion gives the same
// pairs in the same order.
class NearPairs {
  public:
    // Keeps a reference.
    explicit NearPairs(const SurfaceFeatures& features);
    ~NearPairs();

    // All pairs that may come nearer than reach_mm, apart from those of patches that are left out;
    // some that do not, too. Costs the boxes of all patches and the triangles of those that meet.
    std::vector<FeaturePair> along(std::span<const Vec3> from_mm, std::span<const Vec3> to_mm,
                                   double reach_mm,
                                   const std::function<bool(int patch, int other)>& left_out);

  private:
    // A set of vertices in its box at the beginning, all moved by `motion_mm` but for `spread_mm`.
    struct Moving {
        Box box;
        Vec3 motion_mm = Vec3::Zero();
        double spread_mm = 0.0;
    };
    template <class Nodes>
    static Moving moving(const Nodes& nodes, std::span<const Vec3> from_mm,
                         std::span<const Vec3> to_mm);
    // How far apart the two may be at the beginning and yet come within the reach.
    static double range_mm(const Moving& a, const Moving& b, double reach_mm);
    static bool may_meet(const Moving& a, const Moving& b, double reach_mm);
    std::vector<std::array<int, 2>> pairs_of_patches(double reach_mm);
    void add_pairs_of(int patch, int other, std::vector<FeaturePair>& found) const;
    void add_pairs_of_triangles(int a, int b, std::vector<FeaturePair>& found) const;
    void add_vertex(int node, int triangle, double range_mm, std::vector<FeaturePair>& found) const;
    void add_edges(int edge, int other, double range_mm, std::vector<FeaturePair>& found) const;
    void add(FeaturePair pair, double squared_mm2, std::vector<FeaturePair>& found) const;

    const SurfaceFeatures& features_;
    std::unique_ptr<PatchTree> tree_;
    std::vector<Moving> patches_, triangles_;
    std::span<const Vec3> from_mm_, to_mm_;  // of the search under way
    double reach_mm_ = 0.0;
};

}  // namespace hepatica
