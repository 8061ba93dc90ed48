// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/near_pairs.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/parallel.h"

namespace hepatica {
namespace {

constexpr double margin_slacks = 4.0;  // margin of boxes in the tree
// After so many queries all boxes are made anew, so that one that a fast motion widened shrinks.
constexpr int questions_per_box = 64;
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

}  // namespace

NearPairs::NearPairs(const SurfaceFeatures& features, double slack_mm)
    : features_(features), slack_mm_(slack_mm) {}

NearPairs::~NearPairs() = default;

int NearPairs::searches() const {
    int sum = 0;
    for (const Strangers& two : strangers_) sum += two.pairs ? two.pairs->searches() : 0;
    return sum;
}

std::size_t NearPairs::bytes() const {
    std::size_t sum = strangers_.capacity() * sizeof(Strangers);
    for (const Strangers& two : strangers_) sum += two.pairs ? two.pairs->bytes() : 0;
    return sum;
}

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
    // What all fly together is no reason to meet.
    Vec3 common_mm = Vec3::Zero();
    for (const Moving& patch : patches_) common_mm += patch.motion_mm;
    if (!patches_.empty()) common_mm /= static_cast<double>(patches_.size());
    const bool anew = questions_ % questions_per_box == 0;
    bool left = !tree_;
    for (std::size_t p = 0; p < patches_.size(); ++p) {
        const Box needed = grown(patches_[p].swept(common_mm), 0.5 * sweep.reach_mm);
        if (!anew && contains(boxes_[p], needed)) continue;
        boxes_[p] = grown(needed, margin_slacks * slack_mm_);
        left = true;
    }
    if (!left) return;
    if (tree_)
        tree_->refit(boxes_);
    else
        tree_ = std::make_unique<PatchTree>(boxes_);
    keep_strangers(tree_->meeting_pairs());
}

// Keeps what is known of pairs that met before. Both lists are ascending.
void NearPairs::keep_strangers(const std::vector<std::array<int, 2>>& meeting) {
    std::vector<Strangers> now;
    auto before = strangers_.begin();
    for (const auto& pair : meeting) {
        if (features_.neighbours(pair[0], pair[1]) || !features_.may_meet(pair[0], pair[1]))
            continue;
        while (before != strangers_.end() && before->patches < pair) ++before;
        if (before != strangers_.end() && before->patches == pair)
            now.push_back(std::move(*before));
        else
            now.emplace_back().patches = pair;
    }
    strangers_ = std::move(now);
}

bool NearPairs::may_meet(const Strangers& two, double reach_mm) const {
    const auto &one = patches_[two.patches[0]], &other = patches_[two.patches[1]];
    return grown(one.swept(other.motion_mm), reach_mm).meets(grown(other.box, other.spread_mm));
}

void NearPairs::add_pairs_of(Strangers& two, const Sweep& sweep, const LeftOut& left_out,
                             std::optional<double> goes_on_mm, PatchPairSearch& search,
                             std::vector<FeaturePair>& found) const {
    const auto [patch, other] = two.patches;
    if (!two.pairs)
        two.pairs = std::make_unique<ClusterPairs>(features_, patch, std::vector<int>{other});
    const bool goes_on = two.asked == questions_ - 1;
    two.asked = questions_;
    const auto before = static_cast<std::ptrdiff_t>(found.size());
    two.pairs->add_along(sweep, slack_mm_, goes_on ? goes_on_mm : std::nullopt, search, found);
    if (before == std::ssize(found) || !left_out(patch, other)) return;
    found.erase(std::remove_if(found.begin() + before, found.end(),
                               [&](const auto& pair) { return !features_.counts(pair, left_out); }),
                found.end());
}

void NearPairs::add_between_strangers(const Sweep& sweep, const LeftOut& left_out,
                                      std::optional<double> goes_on_mm,
                                      std::vector<FeaturePair>& found) {
    ++questions_;
    find_strangers(sweep);
    std::vector<Strangers*> meeting;
    for (Strangers& two : strangers_)
        if (may_meet(two, sweep.reach_mm)) meeting.push_back(&two);
    const std::size_t blocks = (meeting.size() + pairs_per_block - 1) / pairs_per_block;
    std::vector<std::vector<FeaturePair>> found_in(blocks);
    parallel_blocks(meeting.size(), pairs_per_block, [&](std::size_t begin, std::size_t end) {
        PatchPairSearch search(features_);
        for (std::size_t k = begin; k < end; ++k)
            add_pairs_of(*meeting[k], sweep, left_out, goes_on_mm, search,
                         found_in[begin / pairs_per_block]);
    });
    for (const auto& some : found_in) found.insert(found.end(), some.begin(), some.end());
}

}  // namespace hepatica
