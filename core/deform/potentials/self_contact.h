// SPDX-License-Identifier: GPL-3.0-or-later
// The body's surfaces among each other, as a potential. Between a vertex and a triangle, and
// between two edges, that share no vertex, lies a soft pad of thickness h like a tool's: at the
// distance d < h, with g = 1 - d/h, it stores
//   A p h (-g - ln(1 - g)),    whose force is A p g/(1 - g):
// linear at first and without bound where the gap closes. A is a half of the vertex' share of the
// surface at rest, or the mean of a quarter of each edge's. h is at most half the distance at rest,
// so that the pad is empty there: neighbours count, too. Edges that are parallel have no nearest
// points: there the pad fades out as c (2 - c), with c = sin^2/0.01 of the angle between them (Li
// et al. 2020, eq. 24); vertices and triangles hold those apart. Forces are the exact gradient: a
// pair of them has the sum and the torque zero. The stiffness is that along the normal; what turns
// the normal is left out. Its blocks between the two features are the coupling. Its term of the
// ledger is `contact`. What overlaps at rest: see Overlaps.
#pragma once

#include <memory>
#include <vector>

#include "core/contact/overlaps.h"
#include "core/contact/pair_cover.h"
#include "core/deform/body/body.h"
#include "core/deform/potentials/pair_stiffness.h"
#include "core/deform/potentials/potential.h"
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

// What a surface leaves to the one that it is torn into.
struct BeforeTear {
    OverlapsBefore overlaps;
    int nodes = 0;
    std::shared_ptr<const OverlapsBefore> whole;  // before its first tear, at rest
    int whole_nodes = 0;
};

// False, and nothing changed, where they cannot be of the overlaps' surface.
bool set_pairs(const OverlapsKept& kept, Overlaps& overlaps);

// Keeps a reference to the body, which has a self_pad. Keeps what it found last: not thread-safe.
class SelfContact final : public Potential {
  public:
    explicit SelfContact(const Body& body);

    // In the order of the features: vertices and triangles, then edges.
    const std::vector<SurfaceContact>& contacts(std::span<const Vec3> positions_mm) const;
    SelfLoad load(std::span<const Vec3> positions_mm) const;

    const Overlaps& overlaps() const { return overlaps_; }
    // Lets what has come apart count; looks for what overlaps anew; takes what a checkpoint kept
    // (false where it is not of this body).
    void let_go(std::span<const Vec3> positions_mm);
    void find_overlaps(std::span<const Vec3> positions_mm);
    // Goes on from the surface of the body that this one was torn from; see Overlaps. `parents` is
    // that of each vertex, itself where it has none.
    BeforeTear before_tear() const;
    void follow_split(const BeforeTear& before, std::span<const int> parents,
                      std::span<const Vec3> positions_mm);
    bool set_overlaps(const OverlapsKept& kept);
    OverlapsKept kept_overlaps() const;

    double energy(std::span<const Vec3> positions_mm,
                  std::span<const Vec3> reference_mm) const override;
    void add_energy_by_piece(std::span<const Vec3> positions_mm, std::span<const Vec3> reference_mm,
                             std::span<const int> piece_of_node,
                             std::span<double> energy_nj) const override;
    void add_forces(std::span<const Vec3> positions_mm, std::span<Vec3> forces_un) const override;
    void add_stiffness(std::span<const Vec3> positions_mm, double factor,
                       BlockMatrix& matrix) const override;
    void add_product(std::span<const Vec3> positions_mm, double factor, std::span<const Vec3> d,
                     const BlockMatrix& pattern, std::span<Vec3> product) const override;
    bool coupled(std::span<const Vec3> positions_mm) const override {
        return !contacts(positions_mm).empty();
    }
    void add_coupling(std::span<const Vec3> positions_mm, double factor, std::span<const Vec3> d,
                      std::span<Vec3> product) const override;
    // Pieces that touched at the beginning of the step or where one of its matrices was made, or
    // touch where they were looked at last.
    void join_pieces(std::span<const int> piece_of_node, DisjointSets& pieces) const override;
    void begin_step(const BodyState& start, double dt_s,
                    std::span<const std::uint8_t> held) override;
    void end_step() override;
    void book(double energy_nj, EnergyLedger& ledger) const override {
        ledger.contact += energy_nj;
    }
    // Every gap keeps a tenth of itself, or of the pad where it is wider.
    double free_share(std::span<const Vec3> from_mm, std::span<const Vec3> to_mm) const override;
    // Where something would pass: the share of the motion after which what was farther is half into
    // the pad.
    double share_until_touch(std::span<const Vec3> from_mm,
                             std::span<const Vec3> to_mm) const override;

    // Since it was asked last.
    SelfCost take_cost();

  private:
    double pad_of(const FeaturePair& pair) const;
    std::optional<SurfaceContact> contact_of(const FeaturePair& pair,
                                             std::span<const Vec3> positions_mm) const;
    void fade(SurfaceContact& contact, std::span<const Vec3> positions_mm) const;
    void note_meeting(std::span<const Vec3> positions_mm) const;
    const std::vector<FeaturePair>& candidates(std::span<const Vec3> from_mm,
                                               std::span<const Vec3> to_mm) const;
    // The least share over all pairs of a motion to which kept(gap, pad) >= 0 is left; negative:
    // not asked.
    double least_share(std::span<const Vec3> from_mm, std::span<const Vec3> to_mm,
                       const std::function<double(double gap_mm, double pad_mm)>& kept) const;

    const Body& body_;
    Body::Pad pad_;
    SurfaceFeatures features_;
    Overlaps overlaps_, at_rest_;
    std::shared_ptr<const OverlapsBefore> whole_;  // see BeforeTear; null: this one
    int whole_nodes_ = 0;
    std::span<const std::uint8_t> held_;
    mutable std::vector<std::array<int, 2>> met_;  // nodes of pairs that touched during the step
    mutable PairCover cover_;
    mutable std::vector<Vec3> looked_at_mm_;  // where contacts_ are
    mutable std::vector<SurfaceContact> contacts_;
    double build_ms_ = 0.0;
    mutable double spent_ms_ = 0.0;
};

}  // namespace hepatica
