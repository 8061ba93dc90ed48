// SPDX-License-Identifier: GPL-3.0-or-later
// Finds places where hepatic and portal vessels pass each other, and bends the hepatic one by a
// raised cosine.
#include "core/phantom/phantom_contacts.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

#include "core/phantom/phantom_random.h"
#include "core/tree/extraction/centreline.h"

namespace hepatica {

namespace {

constexpr double farthest_mm = 20.0;   // largest distance between axes that a bend can bring
                                       // together
constexpr double steepest = 0.6;       // largest displacement relative to the bend's half length
constexpr double from_nodes_mm = 6.0;  // contacts keep this far from bifurcations
constexpr double between_contacts_mm = 15.0;
constexpr double contact_free_mm = 0.8;  // kept free around all other vessels
constexpr double crossing_cosine = 0.7;  // largest cosine of the angle between vessels that cross
constexpr double sideways_cosine = 0.5;  // largest cosine between a vessel and its displacement
constexpr double tangent_reach_mm = 3.0;

// A point of a hepatic segment and the nearest one of a portal segment.
struct Approach {
    int hepatic = -1, portal = -1;  // segments
    std::size_t at = 0, to = 0;     // their points
    double distance_mm = 0.0;
    bool crossing = false;
};

// Whether a point of a segment has room for a bend.
bool has_room(const std::vector<double>& along, std::size_t i) {
    return along[i] >= from_nodes_mm && along.back() - along[i] >= from_nodes_mm;
}

class Approaches {
  public:
    explicit Approaches(const VesselTree& tree) : tree_(tree) {
        for (const VesselSegment& segment : tree.segments) {
            along_.push_back(arclengths_mm(segment.points_mm));
            tangents_.push_back(tangents(segment.points_mm, tangent_reach_mm));
        }
    }

    // All approaches at which a vessel can be moved sideways onto the other, the nearest first.
    std::vector<Approach> all() const {
        std::vector<Approach> found;
        for (std::size_t h = 0; h < tree_.segments.size(); ++h)
            for (std::size_t p = 0; p < tree_.segments.size(); ++p)
                if (tree_.segments[h].system == VascularSystem::hepatic &&
                    tree_.segments[p].system == VascularSystem::portal)
                    append(found, static_cast<int>(h), static_cast<int>(p));
        std::ranges::sort(found, {}, [](const Approach& a) {
            return std::tuple(a.distance_mm, a.hepatic, a.portal, a.at);
        });
        return found;
    }

  private:
    void append(std::vector<Approach>& found, int h, int p) const {
        const std::vector<Vec3>& ours = tree_.segments[h].points_mm;
        const std::vector<Vec3>& theirs = tree_.segments[p].points_mm;
        for (std::size_t i = 0; i < ours.size(); ++i) {
            if (!has_room(along_[h], i)) continue;
            Approach best{h, p, i, 0, farthest_mm, false};
            for (std::size_t k = 0; k < theirs.size(); ++k) {
                const double d = (ours[i] - theirs[k]).norm();
                if (d < best.distance_mm) {
                    best.distance_mm = d;
                    best.to = k;
                }
            }
            if (best.distance_mm >= farthest_mm || !has_room(along_[p], best.to)) continue;
            const Vec3 across = (theirs[best.to] - ours[i]).normalized();
            const Vec3 &a = tangents_[h][i], &b = tangents_[p][best.to];
            if (std::max(std::abs(across.dot(a)), std::abs(across.dot(b))) > sideways_cosine)
                continue;
            best.crossing = std::abs(a.dot(b)) < crossing_cosine;
            found.push_back(best);
        }
    }

    const VesselTree& tree_;
    std::vector<std::vector<double>> along_;
    std::vector<std::vector<Vec3>> tangents_;
};

// The segment displaced by `by` at one point and less towards its ends, which stay.
VesselSegment bent(VesselSegment segment, std::size_t at, const Vec3& by) {
    const std::vector<double> along = arclengths_mm(segment.points_mm);
    const double before = along[at], after = along.back() - along[at];
    for (std::size_t i = 0; i < along.size(); ++i) {
        const double u =
            along[i] < before ? (before - along[i]) / before : (along[i] - before) / after;
        const double wave = std::cos(0.5 * std::numbers::pi * u);
        if (i > 0 && i + 1 < along.size()) segment.points_mm[i] += wave * wave * by;
    }
    return segment;
}

// The node that two segments share; -1 where they share none.
int shared_node(const VesselSegment& a, const VesselSegment& b) {
    for (const int node : {a.proximal_node, a.distal_node})
        if (node == b.proximal_node || node == b.distal_node) return node;
    return -1;
}

// Whether a bent segment touches no vessel but the intended one, and that one no deeper than
// intended (axes_mm between the axes). Vessels that share a node with it may touch it near that
// node.
bool is_clear(const VesselTree& tree, const VesselSegment& segment, const Approach& contact,
              double axes_mm) {
    constexpr double spacing_slack = 0.9;  // the axes may be nearer between two points
    for (const Vec3& p : tree.segments[contact.portal].points_mm)
        for (const Vec3& q : segment.points_mm)
            if ((p - q).norm() < spacing_slack * axes_mm) return false;
    for (std::size_t other = 0; other < tree.segments.size(); ++other) {
        const VesselSegment& vessel = tree.segments[other];
        const auto id = static_cast<int>(other);
        if (id == contact.hepatic || id == contact.portal) continue;
        const int node = shared_node(segment, vessel);
        for (std::size_t k = 0; k < vessel.points_mm.size(); ++k) {
            const Vec3& p = vessel.points_mm[k];
            if (node >= 0 && (p - tree.nodes[node].position_mm).norm() < from_nodes_mm) continue;
            for (std::size_t i = 0; i < segment.points_mm.size(); ++i)
                if ((segment.points_mm[i] - p).norm() <
                    segment.radii_mm[i] + vessel.radii_mm[k] + contact_free_mm)
                    return false;
        }
    }
    return true;
}

class Bender {
  public:
    Bender(VesselTree& tree, std::uint64_t seed)
        : tree_(tree), seed_(seed), bent_(tree.segments.size(), 0) {}

    // Bends the first possible approach of the wanted kind; false where there is none.
    bool bend_one(const std::vector<Approach>& all, bool crossing) {
        return std::ranges::any_of(all, [&](const Approach& approach) {
            return approach.crossing == crossing && try_to_bend(approach);
        });
    }

    std::vector<Vec3> places;

  private:
    bool try_to_bend(const Approach& approach) {
        if (bent_[approach.hepatic] != 0) return false;
        const VesselSegment& h = tree_.segments[approach.hepatic];
        const VesselSegment& p = tree_.segments[approach.portal];
        const Vec3 from = h.points_mm[approach.at], to = p.points_mm[approach.to];
        const double ours = h.radii_mm[approach.at], theirs = p.radii_mm[approach.to];
        if (std::ranges::any_of(places, [&](const Vec3& place) {
                return (place - to).norm() < between_contacts_mm;
            }))
            return false;
        const double axes_mm =
            std::max(ours, theirs) + (0.4 + 0.5 * draw(approach)) * std::min(ours, theirs);
        const double by_mm = approach.distance_mm - axes_mm;
        const std::vector<double> along = arclengths_mm(h.points_mm);
        const double room_mm = std::min(along[approach.at], along.back() - along[approach.at]);
        if (by_mm < 0.0 || by_mm > steepest * room_mm) return false;
        VesselSegment moved = bent(h, approach.at, by_mm / approach.distance_mm * (to - from));
        if (!is_clear(tree_, moved, approach, axes_mm)) return false;
        const Vec3 axis = moved.points_mm[approach.at];
        places.push_back(axis + ours / (ours + theirs) * (to - axis));
        tree_.segments[approach.hepatic] = std::move(moved);
        bent_[approach.hepatic] = 1;
        return true;
    }

    // In [0, 1); the same for a pair of segments, whatever was bent before.
    double draw(const Approach& approach) const {
        const auto pair = (static_cast<std::uint64_t>(approach.hepatic) << 32) +
                          static_cast<std::uint64_t>(approach.portal);
        return static_cast<double>(scrambled(seed_ + scrambled(pair)) >> 11) * 0x1p-53;
    }

    VesselTree& tree_;
    std::uint64_t seed_;
    std::vector<std::uint8_t> bent_;
};

}  // namespace

std::vector<Vec3> bend_to_touch(VesselTree& tree, int count, std::uint64_t seed) {
    const std::vector<Approach> all = Approaches(tree).all();
    Bender bender(tree, seed);
    for (bool crossing = true; static_cast<int>(bender.places.size()) < count; crossing = !crossing)
        if (!bender.bend_one(all, crossing) && !bender.bend_one(all, !crossing)) break;
    return bender.places;
}

}  // namespace hepatica
