// SPDX-License-Identifier: GPL-3.0-or-later
// Computes the four terms of evidence and the strengths of ties.
#include "core/tree/systems/system_evidence.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <queue>

namespace hepatica {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double degree = std::numbers::pi / 180.0;

// Weights of the four terms, in log odds; docs/accuracy.md describes how they were found.
constexpr double place_weight = 1.0;
constexpr double taper_weight = 0.67;
constexpr double pointing_weight = 1.0;
constexpr double way_weight = 4.0;

constexpr double straight_tie = 4.0;
constexpr double least_tie = 0.7;
constexpr double bend_scale = 50.0 * degree;
constexpr double brightness_scale = 3.0;  // standard deviations

double clamp_to(double value, double limit) {
    return std::clamp(value, -limit, limit);
}

// How much an arm looks like the parent of its fork: relative radius minus mean cosine to the
// others.
std::vector<double> parenthood(const std::vector<ForkArm>& arms) {
    double widest = 0.0;
    for (const ForkArm& arm : arms) widest = std::max(widest, arm.radius_mm);
    std::vector<double> merit(arms.size());
    const double others = static_cast<double>(arms.size()) - 1.0;
    for (std::size_t i = 0; i < arms.size(); ++i) {
        double alike = 0.0;
        for (std::size_t j = 0; j < arms.size(); ++j)
            if (j != i) alike += arms[i].direction.dot(arms[j].direction);
        merit[i] = arms[i].radius_mm / widest - alike / others;
    }
    return merit;
}

// Unit vector to the confluence minus unit vector to the hilum.
Vec3 towards_confluence(const Vec3& from, const AnatomicalAnchors& anchors) {
    const auto unit = [](const Vec3& v) { return Vec3(v / (v.norm() + 1e-9)); };
    return unit(anchors.confluence_mm - from) - unit(anchors.hilum_mm - from);
}

double place_evidence(const VesselPiece& piece, const AnatomicalAnchors& anchors) {
    constexpr double least_radius_mm = 1.5, range_mm = 2.0, difference_mm = 20.0, reach_mm = 45.0;
    constexpr double reference_mm = 5.0;
    const double hilum = (piece.centre_mm - anchors.hilum_mm).norm();
    const double confluence = (piece.centre_mm - anchors.confluence_mm).norm();
    const double near = std::min(hilum, confluence) / reach_mm;
    const double wide = std::clamp((piece.radius_mm - least_radius_mm) / range_mm, 0.0, 1.0);
    return std::tanh((hilum - confluence) / difference_mm) * std::exp(-near * near) * wide *
           piece.length_mm / reference_mm;
}

double taper_evidence(const VesselPiece& piece, const AnatomicalAnchors& anchors) {
    return piece.link_taper *
           piece.link_direction.dot(towards_confluence(piece.link_centre_mm, anchors));
}

// Shortest paths along the vessels from the pieces of an anchor's trunk.
class WayAlongVessels {
  public:
    explicit WayAlongVessels(const PieceGraph& graph) : graph_(graph), edges_(graph.pieces.size()) {
        for (const auto& [a, b] : graph.passages) connect(a, b, 0.0);
        for (const std::vector<ForkArm>& arms : graph.forks)
            for (std::size_t i = 1; i < arms.size(); ++i)
                for (std::size_t j = 0; j < i; ++j) connect(arms[i], arms[j]);
    }

    std::vector<double> from(const std::vector<int>& sources) const {
        std::vector<double> distance(edges_.size(), infinity);
        using Open = std::pair<double, int>;
        std::priority_queue<Open, std::vector<Open>, std::greater<>> open;
        for (const int source : sources) {
            distance[source] = 0.0;
            open.emplace(0.0, source);
        }
        while (!open.empty()) {
            const auto [d, piece] = open.top();
            open.pop();
            if (d > distance[piece]) continue;
            for (const auto& [next, cost] : edges_[piece]) {
                if (d + cost >= distance[next]) continue;
                distance[next] = d + cost;
                open.emplace(d + cost, next);
            }
        }
        return distance;
    }

  private:
    double resistance(int piece) const {
        const VesselPiece& p = graph_.pieces[piece];
        const double radius = std::max(p.radius_mm, 0.5);
        return p.length_mm / (radius * radius);
    }

    void connect(int a, int b, double toll) {
        const double cost = 0.5 * (resistance(a) + resistance(b)) + toll;
        edges_[a].emplace_back(b, cost);
        edges_[b].emplace_back(a, cost);
    }

    void connect(const ForkArm& a, const ForkArm& b) {
        if (a.piece == b.piece) return;
        constexpr double free_bend = 0.5, toll_mm = 3.0;
        const double bend = std::max(0.0, bend_between(a, b) - free_bend);
        const double radius = std::min(a.radius_mm, b.radius_mm);
        connect(a.piece, b.piece, toll_mm * bend * bend / (radius * radius));
    }

    const PieceGraph& graph_;
    std::vector<std::vector<std::pair<int, double>>> edges_;
};

// The widest pieces around an anchor, on its own side of the other anchor where there are any.
std::vector<int> trunk_at(const std::vector<VesselPiece>& pieces, const Vec3& anchor,
                          const Vec3& other) {
    constexpr double reach_mm = 30.0, margin_mm = 10.0, kept_share = 0.8;
    std::vector<int> near;
    double nearest = infinity;
    for (const VesselPiece& piece : pieces)
        nearest = std::min(nearest, (piece.centre_mm - anchor).norm());
    for (const bool only_own_side : {true, false}) {
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            const double d = (pieces[i].centre_mm - anchor).norm();
            const bool taken = only_own_side
                                   ? d < reach_mm && d < (pieces[i].centre_mm - other).norm()
                                   : d <= nearest + margin_mm;
            if (taken) near.push_back(static_cast<int>(i));
        }
        if (!near.empty()) break;
    }
    std::vector<double> radii;
    for (const int i : near) radii.push_back(pieces[i].radius_mm);
    std::ranges::sort(radii, std::greater<>());
    const std::size_t widest = std::max<std::size_t>(1, radii.size() / 10);
    double mean = 0.0;
    for (std::size_t i = 0; i < widest && i < radii.size(); ++i)
        mean += radii[i] / static_cast<double>(widest);
    std::erase_if(near, [&](int i) { return pieces[i].radius_mm < kept_share * mean; });
    return near;
}

void add_ways(const PieceGraph& graph, const AnatomicalAnchors& anchors,
              std::vector<double>& evidence) {
    constexpr double most = 1.5;  // limit for one fork, before its weight
    const WayAlongVessels ways(graph);
    const Trunks trunks = trunks_at(graph.pieces, anchors);
    const auto to_hilum = ways.from(trunks.portal);
    const auto to_confluence = ways.from(trunks.hepatic);
    for (const std::vector<ForkArm>& arms : graph.forks) {
        if (arms.size() < 3) continue;
        const auto nearest = [&](const std::vector<double>& distance) {
            std::size_t best = 0;
            for (std::size_t i = 1; i < arms.size(); ++i)
                if (distance[arms[i].piece] < distance[arms[best].piece]) best = i;
            return best;
        };
        const std::size_t p = nearest(to_hilum), h = nearest(to_confluence);
        if (p == h || to_hilum[arms[p].piece] == infinity ||
            to_confluence[arms[h].piece] == infinity)
            continue;
        const std::vector<double> merit = parenthood(arms);
        const double value =
            way_weight * clamp_to(merit[h] - merit[p], most) / static_cast<double>(arms.size());
        for (const ForkArm& arm : arms) evidence[arm.piece] += value;
    }
}

void add_pointing(const PieceGraph& graph, const AnatomicalAnchors& anchors,
                  std::vector<double>& evidence) {
    for (const std::vector<ForkArm>& arms : graph.forks) {
        if (arms.size() != 3) continue;
        const std::vector<double> merit = parenthood(arms);
        const ForkArm& parent = arms[std::ranges::max_element(merit) - merit.begin()];
        const double value = pointing_weight / 3.0 *
                             parent.direction.dot(towards_confluence(arms[0].position_mm, anchors));
        for (const ForkArm& arm : arms) evidence[arm.piece] += value;
    }
}

}  // namespace

Trunks trunks_at(const std::vector<VesselPiece>& pieces, const AnatomicalAnchors& anchors) {
    return {trunk_at(pieces, anchors.hilum_mm, anchors.confluence_mm),
            trunk_at(pieces, anchors.confluence_mm, anchors.hilum_mm)};
}

std::vector<double> evidence_for_hepatic(const PieceGraph& graph,
                                         const AnatomicalAnchors& anchors) {
    std::vector<double> evidence;
    for (const VesselPiece& piece : graph.pieces)
        evidence.push_back(place_weight * place_evidence(piece, anchors) +
                           taper_weight * taper_evidence(piece, anchors));
    add_pointing(graph, anchors, evidence);
    add_ways(graph, anchors, evidence);
    return evidence;
}

std::vector<double> ties_of_fork(const std::vector<ForkArm>& arms) {
    constexpr double to_best = 0.7, to_other = 0.2;  // factor where only one arm, or neither, has
                                                     // the other as its best
    const std::size_t n = arms.size();
    const auto likeness = [&](std::size_t i, std::size_t j) {
        const double bend = bend_between(arms[i], arms[j]) / bend_scale;
        const double change = (arms[i].brightness - arms[j].brightness) / brightness_scale;
        return std::exp(-bend * bend - change * change);
    };
    std::vector<std::size_t> best(n, n);
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j)
            if (j != i && (best[i] == n || likeness(i, j) > likeness(i, best[i]))) best[i] = j;
    std::vector<double> ties;
    for (std::size_t i = 1; i < n; ++i)
        for (std::size_t j = 0; j < i; ++j) {
            const int wishes = (best[i] == j ? 1 : 0) + (best[j] == i ? 1 : 0);
            const double share = wishes == 2 ? 1.0 : wishes == 1 ? to_best : to_other;
            ties.push_back(straight_tie * share * likeness(i, j) +
                           least_tie / (static_cast<double>(n) - 1.0));
        }
    return ties;
}

double tie_of_passage(const VesselPiece& a, const VesselPiece& b) {
    const double change = (a.brightness - b.brightness) / (2.0 * brightness_scale);
    return straight_tie * std::exp(-change * change) + least_tie;
}

std::vector<Tie> ties_between(const PieceGraph& graph,
                              const std::function<double(double)>& changed) {
    const auto used = [&](double strength) { return changed ? changed(strength) : strength; };
    std::vector<Tie> ties;
    for (const auto& [a, b] : graph.passages)
        ties.push_back({a, b, used(tie_of_passage(graph.pieces[a], graph.pieces[b]))});
    for (const std::vector<ForkArm>& arms : graph.forks) {
        const std::vector<double> strengths = ties_of_fork(arms);
        std::size_t next = 0;
        for (std::size_t i = 1; i < arms.size(); ++i)
            for (std::size_t j = 0; j < i; ++j) {
                const double strength = used(strengths[next++]);
                if (arms[i].piece != arms[j].piece)
                    ties.push_back({arms[i].piece, arms[j].piece, strength});
            }
    }
    return ties;
}

}  // namespace hepatica
