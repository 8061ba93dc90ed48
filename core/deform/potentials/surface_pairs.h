// SPDX-License-Identifier: GPL-3.0-or-later
// The pads between surfaces. Between a vertex and a triangle, and between two edges, that share no
// vertex, lies a soft pad of thickness h like a tool's: at the distance d < h, with g = 1 - d/h, it
// stores
//   A p h (-g - ln(1 - g)),    whose force is A p g/(1 - g):
// linear at first and without bound where the gap closes. A is a half of the vertex' share of the
// surface at rest, or the mean of a quarter of each edge's; against an obstacle see area_of. h is
// at most half the distance at rest, so that the pad is empty there: neighbours count, too. Edges
// that are parallel have no nearest points: there the pad fades out as c (2 - c), with c =
// sin^2/0.01 of the angle between them (Li et al. 2020, eq. 24); vertices and triangles hold those
// apart. Forces are the exact gradient: a pair of them has the sum and the torque zero. The
// stiffness is that along the normal; what turns the normal is left out. What overlaps at rest: see
// Overlaps.
#pragma once

#include <memory>
#include <vector>

#include "core/contact/overlaps.h"
#include "core/contact/pair_cover.h"
#include "core/deform/body/body.h"
#include "core/deform/potentials/pad_pair.h"
#include "core/deform/potentials/pair_stiffness.h"
#include "core/deform/potentials/self_load.h"

namespace hepatica {

// Two features in their pad.
struct SurfaceContact {
    FeaturePair of;
    PointPair at;
    Vec3 normal = Vec3::Zero();  // from the second to the first, of length 1
    double gap_mm = 0.0;
    double force_un = 0.0;  // along the normal on the first, > 0
    double stiffness_un_per_mm = 0.0;
    double energy_nj = 0.0;
    std::array<Vec3, 4> turning_un{Vec3::Zero(), Vec3::Zero(), Vec3::Zero(),
                                   Vec3::Zero()};  // of edges nearly parallel: sum 0 on each
};

SelfLoad load_of(const std::vector<SurfaceContact>& contacts);

inline Mat3 along_normal(const SurfaceContact& contact) {
    return contact.stiffness_un_per_mm * contact.normal * contact.normal.transpose();
}

// What surfaces leave to those that they are torn into.
struct BeforeTear {
    OverlapsBefore overlaps;
    int nodes = 0;                                // that move
    std::shared_ptr<const OverlapsBefore> whole;  // before the first tear, at rest
    int whole_nodes = 0;
};

// False, and nothing changed, where they cannot be of the overlaps' surface.
bool set_pairs(const OverlapsKept& kept, Overlaps& overlaps);

// Positions are of every node, those of obstacles behind those that move. Keeps what it found last:
// not thread-safe; loops inside run in parallel and give the same bits for any number of threads.
class SurfacePairs {
  public:
    // Keeps a reference to the places at rest.
    SurfacePairs(SurfaceFeatures features, std::span<const Vec3> rest_mm, int moving_nodes,
                 const Body::Pad& pad, double mean_edge_mm);
    SurfacePairs(const SurfacePairs&) = delete;
    SurfacePairs& operator=(const SurfacePairs&) = delete;

    // In the order of the features: vertices and triangles, then edges.
    const std::vector<SurfaceContact>& contacts(std::span<const Vec3> positions_mm) const;
    // All pairs that may be in their pad in one of two places, in the same order: their nodes at
    // one end of a motion or the other.
    void list_touches(std::span<const Vec3> from_mm, std::span<const Vec3> to_mm,
                      std::vector<PadPair>& list) const;
    // Those where it was looked last.
    const std::vector<SurfaceContact>& last_contacts() const { return contacts_; }

    const SurfaceFeatures& features() const { return features_; }
    const Overlaps& overlaps() const { return overlaps_; }
    // Lets what has come apart count; looks for what overlaps anew; takes what a checkpoint kept
    // (false where it is not of these surfaces).
    void let_go(std::span<const Vec3> positions_mm);
    void find_overlaps(std::span<const Vec3> positions_mm);
    // Goes on from the surface of the body that this one was torn from; see Overlaps. `parents` is
    // that of each vertex, itself where it has none.
    BeforeTear before_tear() const;
    void follow_split(const BeforeTear& before, std::span<const int> parents,
                      std::span<const Vec3> positions_mm);
    bool set_overlaps(const OverlapsKept& kept);
    OverlapsKept kept_overlaps() const;

    // See Potential. Every gap keeps a tenth of itself, or of the pad where it is wider.
    // A motion that is asked for again is not looked at again.
    double free_share(std::span<const Vec3> from_mm, std::span<const Vec3> to_mm) const;
    // Where something would pass: the share of the motion after which what was farther is half into
    // the pad.
    double share_until_touch(std::span<const Vec3> from_mm, std::span<const Vec3> to_mm) const;

    // Since it was asked last.
    SelfCost take_cost();

  private:
    double pad_of(const FeaturePair& pair) const;
    double area_of(const FeaturePair& pair) const;
    bool of_obstacle(int node) const { return node >= moving_nodes_; }
    std::optional<SurfaceContact> contact_of(const FeaturePair& pair,
                                             std::span<const Vec3> positions_mm) const;
    bool in_reach(const FeaturePair& pair, std::span<const Vec3> positions_mm) const;
    PadPair pad_pair(const FeaturePair& pair, double pad_mm, double area_mm2) const;
    const std::vector<FeaturePair>& candidates(std::span<const Vec3> from_mm,
                                               std::span<const Vec3> to_mm) const;
    // Of its gap, or of the pad where it is wider, a pair keeps this part; those that begin in
    // their pad may be left out.
    struct Kept {
        double part = 1.0;
        bool only_from_outside = false;
    };
    // The least share of a motion over all pairs, which leaves each what it keeps.
    double least_share(std::span<const Vec3> from_mm, std::span<const Vec3> to_mm,
                       const Kept& kept) const;
    double share_of(const FeaturePair& pair, std::span<const Vec3> from_mm,
                    std::span<const Vec3> to_mm, const Kept& kept) const;
    // Beside obstacles: how far each feature of the body is from all of them at rest.
    void find_clearances();
    double clearance_of(const FeaturePair& pair) const;
    // The node of the surface before from which each came.
    std::vector<int> came_from(std::span<const int> parents, int nodes_before) const;
    void forget();

    std::span<const Vec3> rest_mm_;
    int moving_nodes_;
    Body::Pad pad_;
    SurfaceFeatures features_;
    Overlaps overlaps_, at_rest_;
    std::shared_ptr<const OverlapsBefore> whole_;  // see BeforeTear; null: this one
    int whole_nodes_ = 0;
    std::vector<double> node_clearance_mm_, edge_clearance_mm_, triangle_clearance_mm_;
    mutable PairCover cover_;
    mutable int free_in_answer_ = -1;  // of the cover, to which free_share_ belongs; -1: none
    mutable double free_share_ = 1.0;
    mutable std::vector<Vec3> looked_at_mm_;  // where contacts_ are
    mutable std::vector<SurfaceContact> contacts_;
    double build_ms_ = 0.0;
    mutable double spent_ms_ = 0.0;
};

}  // namespace hepatica
