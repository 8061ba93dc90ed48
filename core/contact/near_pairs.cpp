// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/near_pairs.h"

#include <algorithm>
#include <cmath>

#include "core/base/parallel.h"

namespace hepatica {
namespace {

constexpr std::size_t pairs_per_block = 16;
constexpr std::size_t patches_per_block = 64;

bool contains(const Box& outer, const Box& inner) {
    return (outer.low.array() <= inner.low.array()).all() &&
           (outer.high.array() >= inner.high.array()).all();
}

Box grown(Box box, double margin) {
    box.grow(margin);
    return box;
}

template <class Nodes>
Box swept(const Nodes& nodes, const Sweep& sweep, const Vec3& observer_mm) {
    Box box;
    for (const int v : nodes) box.add(sweep.from_mm[v]);
    if (sweep.stands()) return box;
    for (const int v : nodes) box.add(sweep.to_mm[v] - observer_mm);
    return box;
}

bool shares(const std::array<int, 4>& nodes, int first_count) {
    for (int a = 0; a < first_count; ++a)
        for (int b = first_count; b < 4; ++b)
            if (nodes[a] == nodes[b]) return true;
    return false;
}

// A triangle and its features, each in the box that it sweeps.
struct SweptTriangle {
    int triangle = 0;
    Box box;
};

// One pair of patches, as an observer sees them.
class PairOfPatches {
  public:
    PairOfPatches(const SurfaceFeatures& features, const Sweep& sweep, const Vec3& observer_mm,
                  std::vector<FeaturePair>& found)
        : features_(features), sweep_(sweep), observer_mm_(observer_mm), found_(found) {}

    // The triangles of a patch that come near the box; all that they sweep.
    std::vector<SweptTriangle> near(int patch, const Box& other) const {
        std::vector<SweptTriangle> some;
        for (const int t : features_.surface().triangles_of(patch)) {
            const Box box = swept(features_.surface().triangles()[t], sweep_, observer_mm_);
            if (box.meets(other)) some.push_back({t, box});
        }
        return some;
    }

    void add(const SweptTriangle& a, const SweptTriangle& b) {
        const Box wide_a = grown(a.box, sweep_.reach_mm);
        if (!wide_a.meets(b.box)) return;
        const Box wide_b = grown(b.box, sweep_.reach_mm);
        for (const int v : features_.nodes_owned_by(a.triangle)) add_vertex(v, b.triangle, wide_b);
        for (const int v : features_.nodes_owned_by(b.triangle)) add_vertex(v, a.triangle, wide_a);
        for (const int e : features_.edges_owned_by(a.triangle))
            for (const int f : features_.edges_owned_by(b.triangle)) add_edges(e, f);
    }

  private:
    void add_vertex(int node, int triangle, const Box& wide) {
        const auto& corners = features_.surface().triangles()[triangle];
        const FeaturePair pair{
            .first = node, .second = triangle, .nodes = {node, corners[0], corners[1], corners[2]}};
        if (shares(pair.nodes, 1)) return;
        if (swept(std::array{node}, sweep_, observer_mm_).meets(wide)) found_.push_back(pair);
    }

    void add_edges(int edge, int other) {
        const auto& a = features_.edges()[std::min(edge, other)];
        const auto& b = features_.edges()[std::max(edge, other)];
        const FeaturePair pair{.of_edges = true,
                               .first = std::min(edge, other),
                               .second = std::max(edge, other),
                               .nodes = {a[0], a[1], b[0], b[1]}};
        if (shares(pair.nodes, 2)) return;
        const Box wide = grown(swept(a, sweep_, observer_mm_), sweep_.reach_mm);
        if (wide.meets(swept(b, sweep_, observer_mm_))) found_.push_back(pair);
    }

    const SurfaceFeatures& features_;
    const Sweep& sweep_;
    Vec3 observer_mm_;
    std::vector<FeaturePair>& found_;
};

}  // namespace

NearPairs::~NearPairs() = default;

Box NearPairs::Moving::swept(const Vec3& observer_mm) const {
    Box all = box;
    all.add(box.low + motion_mm - observer_mm);
    all.add(box.high + motion_mm - observer_mm);
    all.grow(spread_mm);
    return all;
}

NearPairs::Moving NearPairs::moving(int patch, const Sweep& sweep) const {
    const auto nodes = features_.surface().vertices_of(patch);
    Moving set;
    for (const int v : nodes) set.box.add(sweep.from_mm[v]);
    if (sweep.stands()) return set;
    for (const int v : nodes) set.motion_mm += sweep.to_mm[v] - sweep.from_mm[v];
    set.motion_mm /= static_cast<double>(nodes.size());
    for (const int v : nodes)
        set.spread_mm = std::max(set.spread_mm,
                                 (sweep.to_mm[v] - sweep.from_mm[v] - set.motion_mm).squaredNorm());
    set.spread_mm = std::sqrt(set.spread_mm);
    return set;
}

// Keeps the pairs of the tree as long as no patch leaves its box there.
void NearPairs::find_strangers(const Sweep& sweep) {
    patches_.resize(features_.surface().size());
    boxes_.resize(patches_.size());
    parallel_blocks(patches_.size(), patches_per_block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t p = begin; p < end; ++p) patches_[p] = moving(static_cast<int>(p), sweep);
    });
    bool left = !tree_;
    for (std::size_t p = 0; p < patches_.size(); ++p) {
        const Box needed = grown(patches_[p].swept(Vec3::Zero()), 0.5 * sweep.reach_mm);
        if (contains(boxes_[p], needed)) continue;
        boxes_[p] = grown(needed, margin_mm_);
        left = true;
    }
    if (!left) return;
    if (tree_)
        tree_->refit(boxes_);
    else
        tree_ = std::make_unique<PatchTree>(boxes_);
    strangers_ = tree_->meeting_pairs();
    std::erase_if(strangers_, [&](const auto& pair) {
        return features_.neighbours(pair[0], pair[1]) || !features_.may_meet(pair[0], pair[1]);
    });
}

bool NearPairs::may_meet(int patch, int other, double reach_mm) const {
    const Vec3& observer = patches_[other].motion_mm;
    return grown(patches_[patch].swept(observer), reach_mm)
        .meets(grown(patches_[other].box, patches_[other].spread_mm));
}

void NearPairs::add_between_strangers(const Sweep& sweep, const LeftOut& left_out,
                                      std::vector<FeaturePair>& found) {
    find_strangers(sweep);
    std::vector<std::array<int, 2>> meeting;
    for (const auto& pair : strangers_)
        if (may_meet(pair[0], pair[1], sweep.reach_mm)) meeting.push_back(pair);
    const std::size_t blocks = (meeting.size() + pairs_per_block - 1) / pairs_per_block;
    std::vector<std::vector<FeaturePair>> found_in(blocks);
    parallel_blocks(meeting.size(), pairs_per_block, [&](std::size_t begin, std::size_t end) {
        std::vector<FeaturePair>& some = found_in[begin / pairs_per_block];
        for (std::size_t k = begin; k < end; ++k) {
            const auto [patch, other] = meeting[k];
            const std::size_t before = some.size();
            add_pairs_of(patch, other, sweep, patches_[other].motion_mm, some);
            if (some.size() == before || !left_out(patch, other)) continue;
            const auto first = some.begin() + static_cast<std::ptrdiff_t>(before);
            some.erase(
                std::remove_if(first, some.end(),
                               [&](const auto& pair) { return !features_.counts(pair, left_out); }),
                some.end());
        }
    });
    for (const auto& some : found_in) found.insert(found.end(), some.begin(), some.end());
}

void NearPairs::add_pairs_of(int patch, int other, const Sweep& sweep,
                             std::vector<FeaturePair>& found) const {
    add_pairs_of(patch, other, sweep, moving(other, sweep).motion_mm, found);
}

void NearPairs::add_pairs_of(int patch, int other, const Sweep& sweep, const Vec3& observer_mm,
                             std::vector<FeaturePair>& found) const {
    PairOfPatches pairs(features_, sweep, observer_mm, found);
    const SurfacePatches& surface = features_.surface();
    const Box box = swept(surface.vertices_of(other), sweep, observer_mm);
    const auto first = pairs.near(patch, grown(box, sweep.reach_mm));
    if (patch == other) {
        for (std::size_t i = 0; i < first.size(); ++i)
            for (std::size_t j = i + 1; j < first.size(); ++j) pairs.add(first[i], first[j]);
        return;
    }
    if (first.empty()) return;
    Box ahead;
    for (const SweptTriangle& t : first) {
        ahead.add(t.box.low);
        ahead.add(t.box.high);
    }
    const auto second = pairs.near(other, grown(ahead, sweep.reach_mm));
    for (const SweptTriangle& t : first)
        for (const SweptTriangle& s : second) pairs.add(t, s);
}

}  // namespace hepatica
