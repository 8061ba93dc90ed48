// SPDX-License-Identifier: GPL-3.0-or-later
// Labels pieces by minimal cuts with anatomy, seeds and brightness, repeats that with perturbed
// evidence for confidences, and rebuilds the graph.
#include "core/tree/systems/tell_systems_apart.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <random>

#include "core/base/disjoint_sets.h"
#include "core/tree/systems/labelled_graph.h"
#include "core/tree/systems/potts_labelling.h"
#include "core/tree/systems/system_evidence.h"
#include "core/tree/systems/vessel_pieces.h"

namespace hepatica {

namespace {

constexpr double brightness_weight = 0.6;  // pieces of one branch are not independent
constexpr double most_brightness = 1.5;    // limit of the log odds per 5 mm
constexpr double reference_mm = 5.0;
constexpr double certain = 1e4;  // log odds of a seed
constexpr double staying = 6.0;  // log odds per 5 mm for the system before
constexpr int portal_label = 0, hepatic_label = 1, artery_label = 2;
constexpr std::array systems_of_labels{VascularSystem::portal, VascularSystem::hepatic,
                                       VascularSystem::artery};

// Least log odds by which two systems must explain the vessels better than one.
constexpr double least_gain = 8.0;

// Cost of one more separate tree of a vein, in log odds.
constexpr double cost_of_a_root = 4.0;

constexpr int draws = 16;
constexpr double draw_deviation = 0.5;  // standard deviation of the logarithm of each weight
constexpr double draw_anchor_mm = 8.0;

std::optional<int> label_of(VascularSystem system) {
    for (std::size_t i = 0; i < systems_of_labels.size(); ++i)
        if (systems_of_labels[i] == system) return static_cast<int>(i);
    return std::nullopt;
}

// Normal deviates from a fixed seed, the same on every machine.
class Noise {
  public:
    double operator()() {
        double sum = 0.0;  // the sum of twelve uniform numbers is nearly normal
        for (int k = 0; k < 12; ++k) sum += static_cast<double>(engine_() >> 11) * 0x1p-53;
        return sum - 6.0;
    }

  private:
    std::mt19937_64 engine_{20120417};
};

struct Labelling {
    std::vector<int> labels;
    double gain = 0.0;  // over one system for all
    double brightness_difference = 0.0;
};

class Search {
  public:
    Search(const PieceGraph& graph, const std::vector<VesselSeed>& seeds, const Job& job,
           const Mask* before = nullptr)
        : graph_(graph), job_(job), seed_label_(graph.pieces.size(), -1) {
        if (before != nullptr)
            for (const VesselPiece& piece : graph.pieces)
                staying_.push_back(odds_of_staying(piece, *before));
        for (const VesselSeed& seed : seeds) place(seed);
    }

    int labels() const { return has_artery_ ? 3 : 2; }
    std::vector<VascularSystem> seeded_systems() const {
        std::vector<VascularSystem> systems;
        for (std::size_t i = 0; i < systems_of_labels.size(); ++i)
            if (std::ranges::count(seed_label_, static_cast<int>(i)) > 0)
                systems.push_back(systems_of_labels[i]);
        return systems;
    }

    Labelling solve(const AnatomicalAnchors& anchors, Noise* noise) const {
        PottsProblem problem;
        problem.labels = labels();
        problem.ties =
            ties_between(graph_, [noise](double strength) { return perturbed(strength, noise); });
        const std::vector<double> evidence = evidence_for_hepatic(graph_, anchors);
        set_costs(problem, evidence, noise);
        Labelling found;
        found.labels = least_energy_labels(problem, job_);
        const PottsProblem without_brightness = problem;
        found = with_brightness(problem, found);
        join_rootless(problem, trunks_at(graph_.pieces, anchors), found.labels);
        found.gain = gain(without_brightness, found.labels) + gain_in_brightness(found.labels);
        return found;
    }

  private:
    void place(const VesselSeed& seed) {
        const std::optional<int> label = label_of(seed.system);
        if (!label || graph_.pieces.empty()) return;
        const auto nearest = std::ranges::min_element(graph_.pieces, {}, [&](const VesselPiece& p) {
            return (p.centre_mm - seed.position_mm).norm() - p.radius_mm;
        });
        seed_label_[nearest - graph_.pieces.begin()] = *label;
        has_artery_ = has_artery_ || *label == artery_label;
    }

    // Log odds of hepatic over portal from the earlier system at the middle of the piece.
    static double odds_of_staying(const VesselPiece& piece, const Mask& before) {
        const auto was = static_cast<VascularSystem>(value_at(before, piece.centre_mm));
        const double odds = staying * piece.length_mm / reference_mm;
        if (was == VascularSystem::hepatic) return odds;
        return was == VascularSystem::portal ? -odds : 0.0;
    }

    static double perturbed(double value, Noise* noise) {
        return noise == nullptr ? value : value * std::exp(draw_deviation * (*noise)());
    }

    void set_costs(PottsProblem& problem, const std::vector<double>& evidence, Noise* noise) const {
        // An artery runs beside the portal vein and is thin; only its seeds favour it.
        constexpr double artery_per_mm = 0.1;
        for (std::size_t i = 0; i < graph_.pieces.size(); ++i) {
            const double odds =
                perturbed(evidence[i], noise) + (staying_.empty() ? 0.0 : staying_[i]);
            std::vector<double> cost{0.5 * odds, -0.5 * odds};
            if (has_artery_)
                cost.push_back(0.5 * odds + artery_per_mm * graph_.pieces[i].length_mm);
            if (seed_label_[i] >= 0)
                for (int label = 0; label < labels(); ++label)
                    if (label != seed_label_[i]) cost[label] += certain;
            problem.costs.push_back(std::move(cost));
        }
    }

    double gain(const PottsProblem& problem, const std::vector<int>& labels) const {
        double one = std::numeric_limits<double>::infinity();
        for (int label = 0; label < problem.labels; ++label)
            one = std::min(one, energy_of(problem, std::vector<int>(graph_.pieces.size(), label)));
        return one - energy_of(problem, labels);
    }

    // Gives connected parts without a piece of their system's trunk to the other vein, the cheapest
    // first, where that costs less than another separate tree.
    void join_rootless(const PottsProblem& problem, const Trunks& trunks,
                       std::vector<int>& labels) const {
        for (;;) {
            const std::vector<int> part = parts_of(problem, labels);
            std::vector<double> cost(labels.size(), 0.0);  // of giving a part away
            std::vector<std::uint8_t> rooted(labels.size(), 0), touches(labels.size(), 0);
            for (const int i : trunks.portal)
                if (labels[i] == portal_label) rooted[part[i]] = 1;
            for (const int i : trunks.hepatic)
                if (labels[i] == hepatic_label) rooted[part[i]] = 1;
            for (std::size_t i = 0; i < labels.size(); ++i) {
                if (labels[i] > hepatic_label)
                    rooted[part[i]] = 1;
                else
                    cost[part[i]] += problem.costs[i][1 - labels[i]] - problem.costs[i][labels[i]];
            }
            for (const Tie& tie : problem.ties)
                if (labels[tie.a] + labels[tie.b] == portal_label + hepatic_label &&
                    labels[tie.a] != labels[tie.b])
                    for (const int i : {tie.a, tie.b}) {
                        cost[part[i]] -= tie.strength;
                        touches[part[i]] = 1;
                    }
            int cheapest = -1;
            for (std::size_t k = 0; k < labels.size(); ++k)
                if (part[k] == static_cast<int>(k) && rooted[k] == 0 && touches[k] != 0 &&
                    (cheapest < 0 || cost[k] < cost[cheapest]))
                    cheapest = static_cast<int>(k);
            if (cheapest < 0 || cost[cheapest] >= cost_of_a_root) return;
            for (std::size_t i = 0; i < labels.size(); ++i)
                if (part[i] == cheapest) labels[i] = 1 - labels[i];
        }
    }

    // The first site of the connected part of one label that each site belongs to.
    static std::vector<int> parts_of(const PottsProblem& problem, const std::vector<int>& labels) {
        DisjointSets parts(labels.size());
        for (const Tie& tie : problem.ties)
            if (labels[tie.a] == labels[tie.b])
                parts.unite(static_cast<std::uint32_t>(tie.a), static_cast<std::uint32_t>(tie.b));
        std::vector<int> part;
        for (std::uint32_t i = 0; i < labels.size(); ++i)
            part.push_back(static_cast<int>(parts.root(i)));
        return part;
    }

    struct BrightnessModel {
        std::array<double, 2> mean{0.0, 0.0};
        double variance = 0.0;        // about the means
        double whole_variance = 0.0;  // about one mean for both
        double length_mm = 0.0;
    };

    // None where one of the veins is too short or brightness does not vary.
    std::optional<BrightnessModel> brightness_of(const std::vector<int>& labels) const {
        std::array<double, 2> sum{0.0, 0.0}, length{0.0, 0.0};
        double squares = 0.0;
        for_veins(labels, [&](const VesselPiece& piece, int label) {
            sum[label] += piece.length_mm * piece.brightness;
            squares += piece.length_mm * piece.brightness * piece.brightness;
            length[label] += piece.length_mm;
        });
        if (std::min(length[0], length[1]) < 5.0 * reference_mm) return std::nullopt;
        BrightnessModel model{
            {sum[0] / length[0], sum[1] / length[1]}, 0.0, 0.0, length[0] + length[1]};
        const double mean = (sum[0] + sum[1]) / model.length_mm;
        model.whole_variance = squares / model.length_mm - mean * mean;
        model.variance =
            (squares - sum[0] * model.mean[0] - sum[1] * model.mean[1]) / model.length_mm;
        if (model.variance <= 1e-12) return std::nullopt;
        return model;
    }

    double gain_in_brightness(const std::vector<int>& labels) const {
        const auto model = brightness_of(labels);
        if (!model) return 0.0;
        return 0.5 * brightness_weight * model->length_mm / reference_mm *
               std::log(model->whole_variance / model->variance);
    }

    // The systems differ slightly in brightness, by an amount known only after they are separated:
    // means and labels are estimated in turn.
    Labelling with_brightness(PottsProblem& problem, Labelling found) const {
        constexpr int rounds = 6;
        constexpr double least_difference = 0.1;
        const std::vector<std::vector<double>> costs = problem.costs;
        for (int round = 0; round < rounds; ++round) {
            const auto model = brightness_of(found.labels);
            if (!model) return found;
            found.brightness_difference =
                (model->mean[1] - model->mean[0]) / std::sqrt(model->variance);
            if (std::abs(found.brightness_difference) <= least_difference) return found;
            for (std::size_t i = 0; i < graph_.pieces.size(); ++i) {
                const double odds = brightness_odds(graph_.pieces[i], *model);
                problem.costs[i][portal_label] = costs[i][portal_label] + 0.5 * odds;
                problem.costs[i][hepatic_label] = costs[i][hepatic_label] - 0.5 * odds;
            }
            std::vector<int> next = least_energy_labels(problem, job_);
            if (next == found.labels) return found;
            found.labels = std::move(next);
        }
        return found;
    }

    // Of hepatic over portal.
    static double brightness_odds(const VesselPiece& piece, const BrightnessModel& model) {
        const double p = piece.brightness - model.mean[0], h = piece.brightness - model.mean[1];
        const double odds = (p * p - h * h) / (2.0 * model.variance);
        return brightness_weight * piece.length_mm / reference_mm *
               std::clamp(odds, -most_brightness, most_brightness);
    }

    template <class Visit>
    void for_veins(const std::vector<int>& labels, const Visit& visit) const {
        for (std::size_t i = 0; i < labels.size(); ++i)
            if (labels[i] <= hepatic_label) visit(graph_.pieces[i], labels[i]);
    }

    const PieceGraph& graph_;
    const Job& job_;
    std::vector<int> seed_label_;  // -1: none
    std::vector<double> staying_;  // empty: not known
    bool has_artery_ = false;
};

Eigen::AlignedBox3d box_of(const VesselGraph& graph) {
    Eigen::AlignedBox3d box;
    for (const VesselNode& node : graph.nodes) box.extend(node.position_mm);
    return box;
}

// Share of draws in which each piece has its label.
std::vector<double> confidences(const Search& search, const AnatomicalAnchors& anchors,
                                const std::vector<int>& labels) {
    std::vector<double> share(labels.size(), 0.0);
    Noise noise;
    for (int draw = 0; draw < draws; ++draw) {
        AnatomicalAnchors moved = anchors;
        for (int axis = 0; axis < 3; ++axis) {
            moved.hilum_mm[axis] += draw_anchor_mm * noise();
            moved.confluence_mm[axis] += draw_anchor_mm * noise();
        }
        const Labelling other = search.solve(moved, &noise);
        for (std::size_t i = 0; i < labels.size(); ++i)
            if (other.labels[i] == labels[i]) share[i] += 1.0 / draws;
    }
    return share;
}

}  // namespace

SystemsFound tell_systems_apart(VesselGraph& graph, const Volume* ct, const SystemSearch& search,
                                const Job& job) {
    SystemsFound found;
    const PieceGraph pieces = pieces_of(graph, ct);
    if (pieces.pieces.empty()) return found;
    found.anchors =
        find_anchors(pieces.pieces, search.liver_mm.isEmpty() ? box_of(graph) : search.liver_mm);
    const Labelling unseeded = Search(pieces, {}, job).solve(found.anchors, nullptr);
    found.gain = unseeded.gain;
    const Search cut(pieces, search.seeds, job);
    std::vector<PieceSystem> systems(pieces.pieces.size());
    const std::vector<VascularSystem> seeded = cut.seeded_systems();
    if (seeded.size() < 2 && unseeded.gain < least_gain) {
        std::ranges::fill(systems, seeded.empty() ? PieceSystem{} : PieceSystem{seeded[0], 1.0});
    } else {
        const bool as_unseeded = seeded.empty() && search.before == nullptr;
        const Labelling best =
            as_unseeded
                ? unseeded
                : Search(pieces, search.seeds, job, search.before).solve(found.anchors, nullptr);
        found.brightness_difference = best.brightness_difference;
        const std::vector<double> confidence = confidences(cut, found.anchors, best.labels);
        for (std::size_t i = 0; i < systems.size(); ++i)
            systems[i] = {systems_of_labels[best.labels[i]], confidence[i]};
    }
    graph = labelled_graph(graph, pieces, systems);
    return found;
}

namespace {

// The largest radius within 10 mm of an end, because a trunk cut off by the image or the liver's
// border tapers over its last millimetres. Points in the lumen of another vessel do not count, so
// that a stub on a trunk is not wide at its beginning.
double radius_near_end(const VesselGraph& graph, const std::vector<std::vector<int>>& at_node,
                       int node) {
    constexpr double reach_mm = 10.0;
    const int id = at_node[node].front();
    const VesselLink& link = graph.links[id];
    const bool first = node == link.from;
    const int other = first ? link.to : link.from;
    double lumen_mm = 0.0;
    for (const int beside : at_node[other])
        if (const VesselLink& vessel = graph.links[beside]; beside != id)
            lumen_mm = std::max(
                lumen_mm, vessel.from == other ? vessel.radii_mm.front() : vessel.radii_mm.back());
    const Vec3& end = graph.nodes[node].position_mm;
    const Vec3& fork = graph.nodes[other].position_mm;
    double radius = first ? link.radii_mm.front() : link.radii_mm.back();
    for (std::size_t i = 0; i < link.points_mm.size(); ++i)
        if ((link.points_mm[i] - end).norm() <= reach_mm &&
            (link.points_mm[i] - fork).norm() > lumen_mm)
            radius = std::max(radius, link.radii_mm[i]);
    return radius;
}

}  // namespace

std::vector<RootWish> anatomical_roots(const VesselGraph& graph, const AnatomicalAnchors& anchors) {
    constexpr double mm_per_radius = 5.0;  // a wider end may lie this much farther from the anchor
    const auto at_node = links_of_nodes(graph);
    const std::vector<int> component = component_of_nodes(graph);
    std::map<int, std::pair<double, RootWish>> best;
    for (std::size_t n = 0; n < graph.nodes.size(); ++n) {
        if (at_node[n].size() != 1) continue;
        const VesselLink& link = graph.links[at_node[n].front()];
        if (link.system == VascularSystem::unknown) continue;
        const Vec3& anchor =
            link.system == VascularSystem::hepatic ? anchors.confluence_mm : anchors.hilum_mm;
        const double away = (graph.nodes[n].position_mm - anchor).norm() -
                            mm_per_radius * radius_near_end(graph, at_node, static_cast<int>(n));
        const auto [entry, is_new] =
            best.try_emplace(component[n], away, RootWish{static_cast<int>(n), link.system});
        if (!is_new && away < entry->second.first)
            entry->second = {away, {static_cast<int>(n), link.system}};
    }
    std::vector<RootWish> wishes;
    for (const auto& [id, wish] : best) wishes.push_back(wish.second);
    return wishes;
}

}  // namespace hepatica
