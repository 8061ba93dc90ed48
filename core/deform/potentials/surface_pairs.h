// SPDX-License-Identifier: GPL-3.0-or-later
// The pads between surfaces. Between a vertex and a triangle, and between two edges, lies a soft
// pad of thickness h unless they share a vertex. At the distance d < h, with g = 1 - d/h, it stores
//   A p h (-g - ln(1 - g)),    whose force is A p g/(1 - g):
// linear at first and without bound as the gap closes. A is half of the vertex' share of the
// surface at rest, or the mean of a quarter of each edge's; against an obstacle see area_of. h is
// at most half the distance at rest, so that neighbours do not press on each other at rest.
// Parallel edges have no unique nearest points; there the pad fades out as c (2 - c), with c =
// sin^2/0.01 of the angle between them (Li et al. 2020, eq. 24), and the pairs of vertices and
// triangles keep them apart. Forces are the exact gradient: the sum and the torque of a pair's
// forces are zero. The stiffness is the part along the normal; the rotation of the normal is left
// out. Overlaps at rest: see Overlaps. Pads that a split has changed: see pair_pads.h.
#pragma once

#include <memory>
#include <vector>

#include "core/contact/overlaps.h"
#include "core/contact/pair_cover.h"
#include "core/contact/torn_sides.h"
#include "core/deform/body/body.h"
#include "core/deform/potentials/pad_pair.h"
#include "core/deform/potentials/pair_pads.h"
#include "core/deform/potentials/pair_stiffness.h"
#include "core/deform/potentials/self_load.h"

namespace hepatica {

// Two features in their pad.
struct SurfaceContact {
    FeaturePair of;
    PointPair at;
    Vec3 normal = Vec3::Zero();  // from the second to the first, of length 1
    double gap_mm = 0.0;
    double force_un = 0.0;  // along the normal on the first, >= 0
    double stiffness_un_per_mm = 0.0;
    double energy_nj = 0.0;
    std::array<Vec3, 4> turning_un{Vec3::Zero(), Vec3::Zero(), Vec3::Zero(),
                                   Vec3::Zero()};  // of nearly parallel edges: sum 0 on each
};

SelfLoad load_of(const std::vector<SurfaceContact>& contacts);

inline Mat3 along_normal(const SurfaceContact& contact) {
    return contact.stiffness_un_per_mm * contact.normal * contact.normal.transpose();
}

// What surfaces hand over to those that they are torn into.
struct BeforeTear {
    OverlapsBefore overlaps;
    int nodes = 0;                                // without those of obstacles
    std::shared_ptr<const OverlapsBefore> whole;  // at rest, before the first tear
    int whole_nodes = 0;
    TornSides::Twins lying;
    std::vector<PressedPair> pressed;
};

// Returns false and changes nothing where the pairs do not fit the surface of the overlaps.
bool set_pairs(const OverlapsKept& kept, Overlaps& overlaps);

// Positions are those of all nodes, the obstacles' after the body's. Caches the last search: not
// thread-safe. Loops inside run in parallel and give the same bits for any number of threads.
class SurfacePairs {
  public:
    // Keeps a reference to the rest positions.
    SurfacePairs(SurfaceFeatures features, std::span<const Vec3> rest_mm, int moving_nodes,
                 const Body::Pad& pad, double mean_edge_mm);
    SurfacePairs(const SurfacePairs&) = delete;
    SurfacePairs& operator=(const SurfacePairs&) = delete;

    // Vertices and triangles first, then edges, each in the order of the features.
    const std::vector<SurfaceContact>& contacts(std::span<const Vec3> positions_mm) const;
    // All pairs that may be in their pad at either end of a motion, in the same order.
    void list_touches(std::span<const Vec3> from_mm, std::span<const Vec3> to_mm,
                      std::vector<PadPair>& list) const;
    // The contacts of the last search.
    const std::vector<SurfaceContact>& last_contacts() const { return contacts_; }

    const SurfaceFeatures& features() const { return features_; }
    const Overlaps& overlaps() const { return overlaps_; }
    // let_go(): what has come apart may touch, and the pads of a split grow. find_overlaps():
    // searches from scratch. set_overlaps(): takes a checkpoint's; false where they are not of
    // these surfaces.
    void let_go(std::span<const Vec3> positions_mm);
    void find_overlaps(std::span<const Vec3> positions_mm);
    // follow_split() continues from the surface of the body that this one was torn from; see
    // Overlaps. `parents` holds each vertex' parent, or the vertex itself.
    BeforeTear before_tear(std::span<const Vec3> positions_mm) const;
    void follow_split(const BeforeTear& before, std::span<const int> parents,
                      std::span<const Vec3> positions_mm);
    bool set_overlaps(const OverlapsKept& kept);
    OverlapsKept kept_overlaps() const;

    // See Potential. Every gap keeps a tenth of itself, or a tenth of the pad where the gap is
    // wider. The answer for the last motion is cached.
    double free_share(std::span<const Vec3> from_mm, std::span<const Vec3> to_mm) const;
    // 1 where nothing would be passed; otherwise the share of the motion after which a pair that
    // began outside its pad is half into it.
    double share_until_touch(std::span<const Vec3> from_mm, std::span<const Vec3> to_mm) const;

    // Costs since the last call.
    SelfCost take_cost();

  private:
    // 0: the pair does not touch.
    double pad_of(const FeaturePair& pair) const;
    double area_of(const FeaturePair& pair) const;
    // The same without what a split has changed.
    double whole_pad_of(const FeaturePair& pair) const;
    double whole_area_of(const FeaturePair& pair) const;
    LeftOut left_out() const {
        return [this](int patch, int other) { return overlaps_.left_out(patch, other); };
    }
    std::vector<PressedPair> pressed(std::span<const Vec3> positions_mm) const;
    bool grow_pads(std::span<const Vec3> positions_mm);
    bool of_obstacle(int node) const { return node >= moving_nodes_; }
    std::optional<SurfaceContact> contact_of(const FeaturePair& pair,
                                             std::span<const Vec3> positions_mm) const;
    bool in_reach(const FeaturePair& pair, std::span<const Vec3> positions_mm) const;
    PadPair pad_pair(const FeaturePair& pair, double pad_mm, double area_mm2) const;
    const std::vector<FeaturePair>& candidates(std::span<const Vec3> from_mm,
                                               std::span<const Vec3> to_mm) const;
    // The part of its gap, or of the pad where the gap is wider, that a pair must keep; pairs that
    // begin inside their pad may be exempt.
    struct Kept {
        double part = 1.0;
        bool only_from_outside = false;
    };
    // The largest share of a motion for which every pair keeps that part.
    double least_share(std::span<const Vec3> from_mm, std::span<const Vec3> to_mm,
                       const Kept& kept) const;
    double share_of(const FeaturePair& pair, std::span<const Vec3> from_mm,
                    std::span<const Vec3> to_mm, const Kept& kept) const;
    // Beside obstacles: the distance of each feature of the body to all of them at rest.
    void find_clearances();
    double clearance_of(const FeaturePair& pair) const;
    // The node of the earlier surface that each node came from.
    std::vector<int> came_from(std::span<const int> parents, int nodes_before) const;
    void forget();

    std::span<const Vec3> rest_mm_;
    int moving_nodes_;
    Body::Pad pad_;
    SurfaceFeatures features_;
    Overlaps overlaps_, at_rest_;
    TornSides sides_;                              // of surfaces among each other
    std::vector<PairPad> pads_;                    // of a split, ascending
    std::shared_ptr<const OverlapsBefore> whole_;  // see BeforeTear; null: not torn yet
    int whole_nodes_ = 0;
    std::vector<double> node_clearance_mm_, edge_clearance_mm_, triangle_clearance_mm_;
    mutable PairCover cover_;
    mutable int free_in_answer_ = -1;  // the answer of cover_ for which free_share_ holds; -1: none
    mutable double free_share_ = 1.0;
    mutable std::vector<Vec3> looked_at_mm_;  // the positions that contacts_ belong to
    mutable std::vector<SurfaceContact> contacts_;
    double build_ms_ = 0.0;
    mutable double spent_ms_ = 0.0;
};

}  // namespace hepatica
