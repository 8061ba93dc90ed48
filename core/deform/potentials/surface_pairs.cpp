// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/potentials/surface_pairs.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "core/base/parallel.h"
#include "core/base/small_matrix_eigen.h"
#include "core/contact/time_of_contact.h"
#include "core/deform/body/torn_body.h"

namespace hepatica {
namespace {

constexpr double least_part = 0.1;         // share of a gap that a motion must leave
constexpr double touched = 0.5;            // of the pad, for share_until_touch()
constexpr double touching_at_rest = 0.05;  // of the pad: nearer is overlap
constexpr double least_opening = 0.05;     // of the pad: sides of a tear that have come apart
constexpr double slack_edges = 0.25;       // slack of the search in mean edges; see PairCover
constexpr double band = 1e-3;              // relative tolerance of times of contact
constexpr double coincident = 1e-9;        // of the pad: a distance at rest that is rounding
constexpr double beyond_rounding = 1.0 + 1e-9;
constexpr std::size_t pairs_per_block = 128;

// Adds the time between its construction and destruction to a sum.
class Stopwatch {
  public:
    explicit Stopwatch(double& sum_ms) : sum_ms_(sum_ms) {}
    ~Stopwatch() {
        const std::chrono::duration<double, std::milli> gone = Clock::now() - begin_;
        sum_ms_ += gone.count();
    }
    Stopwatch(const Stopwatch&) = delete;
    Stopwatch& operator=(const Stopwatch&) = delete;

  private:
    using Clock = std::chrono::steady_clock;
    double& sum_ms_;
    Clock::time_point begin_ = Clock::now();
};

Segment segment(const FeaturePair& pair, int first, std::span<const Vec3> x) {
    return {x[pair.nodes[first]], x[pair.nodes[first + 1]]};
}

Triangle triangle(const FeaturePair& pair, std::span<const Vec3> x) {
    return {x[pair.nodes[1]], x[pair.nodes[2]], x[pair.nodes[3]]};
}

int in_first(const FeaturePair& pair) {
    return pair.of_edges ? 2 : 1;
}

struct Corners {
    small::Vector3<double> x[4];
};

Corners corners(const FeaturePair& pair, std::span<const Vec3> x) {
    Corners of;
    for (int a = 0; a < 4; ++a) of.x[a] = small::from_eigen(x[pair.nodes[a]]);
    return of;
}

// A lower bound on the distance of the two features, squared: that of their boxes.
double squared_gap_of_boxes_mm2(const FeaturePair& pair, std::span<const Vec3> x) {
    Box first, second;
    for (int a = 0; a < 4; ++a) (a < in_first(pair) ? first : second).add(x[pair.nodes[a]]);
    const Vec3 apart = (first.low - second.high).cwiseMax(second.low - first.high);
    return apart.cwiseMax(Vec3::Zero()).squaredNorm();
}

// An upper bound on how much the distance of the two features decreases.
double approach_mm(const FeaturePair& pair, std::span<const Vec3> from, std::span<const Vec3> to) {
    const auto moved = [&](int a) -> Vec3 { return to[pair.nodes[a]] - from[pair.nodes[a]]; };
    double squared = 0.0;
    for (int a = 0; a < in_first(pair); ++a)
        for (int b = in_first(pair); b < 4; ++b)
            squared = std::max(squared, (moved(a) - moved(b)).squaredNorm());
    return std::sqrt(squared);
}

std::optional<double> time_to(const FeaturePair& pair, std::span<const Vec3> from,
                              std::span<const Vec3> to, double keep_mm, double tolerance_mm) {
    if (pair.of_edges)
        return time_of_contact(Motion<Segment>{segment(pair, 0, from), segment(pair, 0, to)},
                               Motion<Segment>{segment(pair, 2, from), segment(pair, 2, to)},
                               keep_mm, tolerance_mm);
    return time_of_contact(Motion<Vec3>{from[pair.nodes[0]], to[pair.nodes[0]]},
                           Motion<Triangle>{triangle(pair, from), triangle(pair, to)}, keep_mm,
                           tolerance_mm);
}

std::vector<int> one_by_one(const Overlaps::Pairs& pairs) {
    std::vector<int> all;
    for (const auto& pair : pairs) all.insert(all.end(), pair.begin(), pair.end());
    return all;
}

// Appends what `find` finds for each pair, in their order; searches in parallel.
template <class Found, class Find>
void append_of_each(const std::vector<FeaturePair>& pairs, std::vector<Found>& all,
                    const Find& find) {
    std::vector<std::vector<Found>> found((pairs.size() + pairs_per_block - 1) / pairs_per_block);
    parallel_blocks(pairs.size(), pairs_per_block, [&](std::size_t begin, std::size_t end) {
        std::vector<Found>& of_block = found[begin / pairs_per_block];
        of_block.reserve(end - begin);
        for (std::size_t k = begin; k < end; ++k)
            if (const auto some = find(pairs[k])) of_block.push_back(*some);
    });
    std::size_t count = all.size();
    for (const auto& some : found) count += some.size();
    all.reserve(count);
    for (const auto& some : found) all.insert(all.end(), some.begin(), some.end());
}

Overlaps::Pairs in_pairs(const std::vector<int>& all) {
    Overlaps::Pairs pairs;
    for (std::size_t i = 0; i + 1 < all.size(); i += 2) pairs.push_back({all[i], all[i + 1]});
    return pairs;
}

}  // namespace

SurfacePairs::SurfacePairs(SurfaceFeatures features, std::span<const Vec3> rest_mm,
                           int moving_nodes, const Body::Pad& pad, double mean_edge_mm)
    : rest_mm_(rest_mm),
      moving_nodes_(moving_nodes),
      pad_(pad),
      features_(std::move(features)),
      overlaps_(features_),
      at_rest_(features_),
      sides_(features_),
      cover_(features_, pad_.thickness_mm, slack_edges * mean_edge_mm) {
    const Stopwatch watch(build_ms_);
    at_rest_.find(rest_mm, touching_at_rest * pad_.thickness_mm);
    overlaps_.set(at_rest_.touching(), at_rest_.buried());
    find_clearances();
    candidates(rest_mm, rest_mm);
}

void SurfacePairs::forget() {
    cover_.forget();
    free_in_answer_ = -1;
    looked_at_mm_.clear();
}

void SurfacePairs::let_go(std::span<const Vec3> positions_mm) {
    const Stopwatch watch(spent_ms_);
    if (overlaps_.let_go(positions_mm, pad_.thickness_mm)) forget();
    const bool grown = grow_pads(positions_mm);
    const auto counting = sides_.let_go(positions_mm, least_opening * pad_.thickness_mm);
    add_new(counting, positions_mm, pad_.thickness_mm, pads_);
    if (!grown && counting.empty()) return;
    free_in_answer_ = -1;
    looked_at_mm_.clear();  // a gap that is the pad's up to rounding may be a contact
}

bool SurfacePairs::grow_pads(std::span<const Vec3> positions_mm) {
    const auto as_pair = [](const PairPad& pad) {
        return FeaturePair{.of_edges = pad.in_first == 2, .nodes = pad.nodes};
    };
    bool any = false;
    std::erase_if(pads_, [&](PairPad& pad) {
        const double gap = distance_mm(as_pair(pad), positions_mm);
        any = any || gap >= pad.pad_mm;
        return !grow(pad, gap);
    });
    return any;
}

void SurfacePairs::find_overlaps(std::span<const Vec3> positions_mm) {
    overlaps_.find(positions_mm, touching_at_rest * pad_.thickness_mm, &at_rest_);
    sides_.find(positions_mm, least_opening * pad_.thickness_mm);
    pads_.clear();
    forget();
}

BeforeTear SurfacePairs::before_tear(std::span<const Vec3> positions_mm) const {
    BeforeTear before{.overlaps = {features_, overlaps_.touching(), overlaps_.buried()},
                      .nodes = moving_nodes_,
                      .whole = whole_,
                      .whole_nodes = whole_nodes_,
                      .lying = sides_.lying(),
                      .pressed = pressed(positions_mm)};
    if (whole_) return before;
    const OverlapsBefore rest{features_, at_rest_.touching(), at_rest_.buried()};
    before.whole = std::make_shared<OverlapsBefore>(rest);
    before.whole_nodes = moving_nodes_;
    return before;
}

std::vector<PressedPair> SurfacePairs::pressed(std::span<const Vec3> positions_mm) const {
    std::vector<PressedPair> pairs;
    for (const SurfaceContact& contact : contacts(positions_mm))
        pairs.push_back({contact.of, pad_of(contact.of), area_of(contact.of), contact.gap_mm});
    return pairs;
}

// Nodes of obstacles are numbered after all others.
std::vector<int> SurfacePairs::came_from(std::span<const int> parents, int nodes_before) const {
    std::vector<int> from = hepatica::nodes_before(parents, nodes_before);
    for (std::size_t v = parents.size(); v < rest_mm_.size(); ++v)
        from.push_back(nodes_before + static_cast<int>(v - parents.size()));
    return from;
}

// The overlaps at rest continue from the whole body, so that they do not depend on the order of
// tears.
void SurfacePairs::follow_split(const BeforeTear& before, std::span<const int> parents,
                                std::span<const Vec3> positions_mm) {
    const Stopwatch watch(spent_ms_);
    whole_ = before.whole;
    whole_nodes_ = before.whole_nodes;
    const std::vector<int> node_of_whole = came_from(parents, whole_nodes_);
    const std::vector<int> node_before = came_from(parents, before.nodes);
    at_rest_.follow_split(*whole_, node_of_whole, rest_mm_, touching_at_rest * pad_.thickness_mm);
    TornSides::PatchPairs parted;
    if (!features_.beside_obstacles())
        parted = sides_.follow_split(before.lying, node_before, node_of_whole);
    overlaps_.follow_split(before.overlaps, node_before, positions_mm, pad_.thickness_mm, &parted);
    find_clearances();
    forget();
    pads_.clear();
    pads_ = pads_after_split(before.pressed, pressed(positions_mm), node_before);
    looked_at_mm_.clear();
}

bool set_pairs(const OverlapsKept& kept, Overlaps& overlaps) {
    return kept.touching.size() % 2 == 0 && kept.buried.size() % 2 == 0 &&
           overlaps.set(in_pairs(kept.touching), in_pairs(kept.buried));
}

bool SurfacePairs::set_overlaps(const OverlapsKept& kept) {
    if (!are_pads(kept.pads, static_cast<int>(rest_mm_.size()))) return false;
    if (kept.lying.size() % 2 != 0) return false;
    const TornSides::Twins lying = sides_.lying();
    if (!sides_.set(in_pairs(kept.lying))) return false;
    if (!set_pairs(kept, overlaps_)) {
        sides_.set(lying);
        return false;
    }
    pads_ = kept.pads;
    forget();
    return true;
}

OverlapsKept SurfacePairs::kept_overlaps() const {
    return {one_by_one(overlaps_.touching()), one_by_one(overlaps_.buried()),
            one_by_one(sides_.lying()), pads_};
}

void SurfacePairs::find_clearances() {
    if (!features_.beside_obstacles()) return;
    node_clearance_mm_.assign(rest_mm_.size(), INFINITY);
    edge_clearance_mm_.assign(features_.edges().size(), INFINITY);
    triangle_clearance_mm_.assign(features_.surface().triangles().size(), INFINITY);
    std::vector<FeaturePair> near;
    NearPairs(features_, 0.0)
        .add_between_strangers(
            {rest_mm_, rest_mm_, 2.0 * pad_.thickness_mm},
            [&](int p, int q) { return at_rest_.left_out(p, q); }, std::nullopt, near);
    const auto take = [](double& least, double distance) { least = std::min(least, distance); };
    for (const FeaturePair& pair : near) {
        const double apart = distance_mm(pair, rest_mm_);
        if (pair.of_edges)
            take(edge_clearance_mm_[of_obstacle(pair.nodes[0]) ? pair.second : pair.first], apart);
        else if (of_obstacle(pair.first))
            take(triangle_clearance_mm_[pair.second], apart);
        else
            take(node_clearance_mm_[pair.first], apart);
    }
}

double SurfacePairs::clearance_of(const FeaturePair& pair) const {
    if (pair.of_edges)
        return edge_clearance_mm_[of_obstacle(pair.nodes[0]) ? pair.second : pair.first];
    return of_obstacle(pair.first) ? triangle_clearance_mm_[pair.second]
                                   : node_clearance_mm_[pair.first];
}

// Half the distance at rest, but the full thickness for pairs that overlapped at rest. Against
// obstacles, half the distance of the body's feature to any of them, so that the pad stays the same
// wherever it slides.
double SurfacePairs::whole_pad_of(const FeaturePair& pair) const {
    if (features_.beside_obstacles()) return std::min(pad_.thickness_mm, 0.5 * clearance_of(pair));
    if (!features_.counts(pair, [&](int p, int q) { return at_rest_.left_out(p, q); }))
        return pad_.thickness_mm;
    if (sides_.shared_a_vertex(pair)) return pad_.thickness_mm;
    // Pieces that lie on each other at rest, up to rounding, have no pad.
    const double pad = std::min(pad_.thickness_mm, 0.5 * distance_mm(pair, rest_mm_));
    return pad > coincident * pad_.thickness_mm ? pad : 0.0;
}

const std::vector<FeaturePair>& SurfacePairs::candidates(std::span<const Vec3> from_mm,
                                                         std::span<const Vec3> to_mm) const {
    return cover_.along(from_mm, to_mm, left_out());
}

// Against an obstacle the body's vertices carry their full area, but edges and vertices of the
// obstacle only in proportion to their sharpness: in a flat face they never come nearer than a
// vertex of the body, and would act as ridges on what slides across.
double SurfacePairs::whole_area_of(const FeaturePair& pair) const {
    if (!features_.beside_obstacles())
        return pair.of_edges ? 0.25 * (features_.area_of_edge_mm2(pair.first) +
                                       features_.area_of_edge_mm2(pair.second))
                             : 0.5 * features_.area_of_node_mm2(pair.first);
    if (pair.of_edges) {
        const bool first = of_obstacle(pair.nodes[0]);
        return 0.5 * features_.sharpness_of_edge(first ? pair.first : pair.second) *
               features_.area_of_edge_mm2(first ? pair.second : pair.first);
    }
    if (!of_obstacle(pair.first)) return features_.area_of_node_mm2(pair.first);
    double share = 0.0;
    for (int a = 1; a < 4; ++a) share += features_.area_of_node_mm2(pair.nodes[a]) / 3.0;
    return 0.5 * features_.sharpness_of_node(pair.first) * share;
}

double SurfacePairs::pad_of(const FeaturePair& pair) const {
    if (sides_.lie_on_each_other(pair)) return 0.0;
    const PairPad* const of_split = find_pad(pads_, pair);
    return of_split ? of_split->pad_mm : whole_pad_of(pair);
}

double SurfacePairs::area_of(const FeaturePair& pair) const {
    const PairPad* const of_split = find_pad(pads_, pair);
    return (of_split ? of_split->share : 1.0) * whole_area_of(pair);
}

PadPair SurfacePairs::pad_pair(const FeaturePair& pair, double pad_mm, double area_mm2) const {
    PadPair with{{}, in_first(pair), pad_mm, area_mm2 * pad_.pressure_pa, 0.0};
    std::ranges::copy(pair.nodes, with.nodes);
    const auto& n = pair.nodes;
    if (pair.of_edges)
        with.parallel_mm4 = nearly_parallel * (rest_mm_[n[1]] - rest_mm_[n[0]]).squaredNorm() *
                            (rest_mm_[n[3]] - rest_mm_[n[2]]).squaredNorm();
    return with;
}

std::optional<SurfaceContact> SurfacePairs::contact_of(const FeaturePair& pair,
                                                       std::span<const Vec3> x) const {
    const double most = pad_.thickness_mm;
    if (squared_gap_of_boxes_mm2(pair, x) >= most * most) return std::nullopt;
    const Corners at = corners(pair, x);
    const NearestPoints near = nearest_points(in_first(pair), at.x);
    if (!(near.gap_mm < most)) return std::nullopt;
    const double pad = pad_of(pair);
    if (!(near.gap_mm < pad)) return std::nullopt;
    const double area = area_of(pair);
    if (area == 0.0) return std::nullopt;
    const PairPull pull = pull_of(pad_pair(pair, pad, area), near, at.x);
    SurfaceContact contact{.of = pair, .at = {.nodes = pair.nodes, .in_first = in_first(pair)}};
    std::ranges::copy(near.weights, contact.at.weights.begin());
    contact.normal = small::to_eigen(pull.normal);
    contact.gap_mm = near.gap_mm;
    contact.force_un = pull.pad.force_un;
    contact.stiffness_un_per_mm = pull.pad.stiffness_un_per_mm;
    contact.energy_nj = pull.pad.energy_nj;
    const Vec3 first = small::to_eigen(pull.turning_first_un);
    const Vec3 second = small::to_eigen(pull.turning_second_un);
    contact.turning_un = {-first, first, -second, second};
    return contact;
}

bool SurfacePairs::in_reach(const FeaturePair& pair, std::span<const Vec3> x) const {
    const double most = pad_.thickness_mm;
    return squared_gap_of_boxes_mm2(pair, x) < most * most && distance_mm(pair, x) < most;
}

void SurfacePairs::list_touches(std::span<const Vec3> from_mm, std::span<const Vec3> to_mm,
                                std::vector<PadPair>& list) const {
    const Stopwatch watch(spent_ms_);
    append_of_each<PadPair>(candidates(from_mm, to_mm), list, [&](const FeaturePair& pair) {
        std::optional<PadPair> touch;
        if (!in_reach(pair, from_mm) && !in_reach(pair, to_mm)) return touch;
        const double area = area_of(pair), pad = pad_of(pair);
        if (area != 0.0 && pad != 0.0) touch = pad_pair(pair, pad, area);
        return touch;
    });
}

const std::vector<SurfaceContact>& SurfacePairs::contacts(
    std::span<const Vec3> positions_mm) const {
    if (std::ranges::equal(looked_at_mm_, positions_mm)) return contacts_;
    const Stopwatch watch(spent_ms_);
    contacts_.clear();
    append_of_each<SurfaceContact>(
        candidates(positions_mm, positions_mm), contacts_,
        [&](const FeaturePair& pair) { return contact_of(pair, positions_mm); });
    looked_at_mm_.assign(positions_mm.begin(), positions_mm.end());
    return contacts_;
}

SelfLoad load_of(const std::vector<SurfaceContact>& contacts) {
    SelfLoad load;
    for (const SurfaceContact& contact : contacts) {
        ++load.contacts;
        load.least_gap_mm = std::min(load.least_gap_mm, contact.gap_mm);
    }
    return load;
}

double SurfacePairs::least_share(std::span<const Vec3> from_mm, std::span<const Vec3> to_mm,
                                 const Kept& kept) const {
    const Stopwatch watch(spent_ms_);
    const std::vector<FeaturePair>& near = candidates(from_mm, to_mm);
    const std::size_t blocks = (near.size() + pairs_per_block - 1) / pairs_per_block;
    std::vector<double> share(blocks, 1.0);
    parallel_blocks(near.size(), pairs_per_block, [&](std::size_t begin, std::size_t end) {
        double& least = share[begin / pairs_per_block];
        for (std::size_t k = begin; k < end; ++k)
            least = std::min(least, share_of(near[k], from_mm, to_mm, kept));
    });
    return share.empty() ? 1.0 : *std::ranges::min_element(share);
}

// Most pairs stay far apart; cheap bounds discard them before the exact time of contact.
double SurfacePairs::share_of(const FeaturePair& pair, std::span<const Vec3> from_mm,
                              std::span<const Vec3> to_mm, const Kept& kept) const {
    const double approach = beyond_rounding * approach_mm(pair, from_mm, to_mm);
    const auto stays_away = [&](double gap, double pad) {
        return gap - kept.part * std::min(gap, pad) > approach;
    };
    const double least_gap = std::sqrt(squared_gap_of_boxes_mm2(pair, from_mm));
    if (stays_away(least_gap, pad_.thickness_mm)) return 1.0;
    const double gap = distance_mm(pair, from_mm);
    if (stays_away(gap, pad_.thickness_mm)) return 1.0;
    const double pad = pad_of(pair);
    if (pad == 0.0) return 1.0;
    if ((kept.only_from_outside && gap <= pad) || stays_away(gap, pad)) return 1.0;
    const double keep = kept.part * std::min(gap, pad);
    const double tolerance = std::min(band * std::max(gap - keep, keep), keep);
    return std::min(1.0, time_to(pair, from_mm, to_mm, keep, tolerance).value_or(1.0));
}

double SurfacePairs::free_share(std::span<const Vec3> from_mm, std::span<const Vec3> to_mm) const {
    if (free_in_answer_ == cover_.answers() && cover_.is_of(from_mm, to_mm)) return free_share_;
    const double share = least_share(from_mm, to_mm, {.part = least_part});
    if (cover_.is_of(from_mm, to_mm)) {
        free_in_answer_ = cover_.answers();
        free_share_ = share;
    }
    return share;
}

double SurfacePairs::share_until_touch(std::span<const Vec3> from_mm,
                                       std::span<const Vec3> to_mm) const {
    if (free_share(from_mm, to_mm) == 1.0) return 1.0;
    return least_share(from_mm, to_mm, {.part = touched, .only_from_outside = true});
}

SelfCost SurfacePairs::take_cost() {
    return {.bytes = features_.bytes() + cover_.bytes() + looked_at_mm_.capacity() * sizeof(Vec3) +
                     pads_.capacity() * sizeof(PairPad) +
                     contacts_.capacity() * sizeof(SurfaceContact),
            .build_ms = build_ms_,
            .step_ms = std::exchange(spent_ms_, 0.0)};
}

}  // namespace hepatica
