// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/pair_cover.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/base/parallel.h"

namespace hepatica {
namespace {

constexpr double same_slacks = 0.01;  // positions no farther apart are taken as the same
constexpr std::size_t nodes_per_block = 4096;

bool same_places(std::span<const Vec3> a, std::span<const Vec3> b) {
    return std::ranges::equal(a, b);
}

}  // namespace

PairCover::PairCover(const SurfaceFeatures& features, double reach_mm, double slack_mm)
    : features_(features),
      strangers_(features, slack_mm),
      neighbours_(features, slack_mm),
      reach_mm_(reach_mm),
      same_mm_(same_slacks * slack_mm) {}

std::size_t PairCover::bytes() const {
    return (near_.capacity() + unsorted_.capacity()) * sizeof(FeaturePair) +
           begin_.capacity() * sizeof(int) +
           (from_mm_.capacity() + to_mm_.capacity()) * sizeof(Vec3) + strangers_.bytes() +
           neighbours_.bytes();
}

bool PairCover::is_of(std::span<const Vec3> from_mm, std::span<const Vec3> to_mm) const {
    return known_ && same_places(from_mm, from_mm_) && same_places(to_mm, to_mm_);
}

// Whether all vertices are at this share of the last motion.
bool PairCover::near_all(std::span<const Vec3> positions_mm, double share) const {
    const std::vector<int>& nodes = features_.nodes();
    const double apart = parallel_sum(nodes.size(), nodes_per_block, [&](auto begin, auto end) {
        for (std::size_t i = begin; i < end; ++i) {
            const int v = nodes[i];
            const Vec3 there = from_mm_[v] + share * (to_mm_[v] - from_mm_[v]);
            if (!((positions_mm[v] - there).squaredNorm() <= same_mm_ * same_mm_)) return 1.0;
        }
        return 0.0;
    });
    return apart == 0.0;
}

// Whether all vertices are at the same share of the last motion, found by least squares.
bool PairCover::on_the_way(std::span<const Vec3> positions_mm) const {
    const std::vector<int>& nodes = features_.nodes();
    const auto sum = [&](const auto& of_node) {
        return parallel_sum(nodes.size(), nodes_per_block, [&](auto begin, auto end) {
            double part = 0.0;
            for (std::size_t i = begin; i < end; ++i) part += of_node(nodes[i]);
            return part;
        });
    };
    const double whole = sum([&](int v) { return (to_mm_[v] - from_mm_[v]).squaredNorm(); });
    if (!(whole > 0.0)) return near_all(positions_mm, 0.0);
    const double along = sum(
        [&](int v) { return Vec3(to_mm_[v] - from_mm_[v]).dot(positions_mm[v] - from_mm_[v]); });
    return near_all(positions_mm, std::clamp(along / whole, 0.0, 1.0));
}

bool PairCover::at_its_end(std::span<const Vec3> positions_mm) const {
    return near_all(positions_mm, 1.0);
}

// Counting sort by the first feature, then a sort of the few pairs of each.
void PairCover::sort_by_feature(std::size_t nodes) {
    const auto place = [&](const FeaturePair& pair) {
        return (pair.of_edges ? nodes : 0) + static_cast<std::size_t>(pair.first);
    };
    begin_.assign(nodes + features_.edges().size() + 1, 0);
    for (const FeaturePair& pair : unsorted_) ++begin_[place(pair) + 1];
    std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
    near_.resize(unsorted_.size());
    for (const FeaturePair& pair : unsorted_)
        near_[static_cast<std::size_t>(begin_[place(pair)]++)] = pair;
    for (auto first = near_.begin(); first != near_.end();) {
        auto last = first + 1;
        while (last != near_.end() && place(*last) == place(*first)) ++last;
        if (last - first > 1)
            std::sort(first, last,
                      [](const auto& a, const auto& b) { return a.second < b.second; });
        first = last;
    }
}

const std::vector<FeaturePair>& PairCover::along(std::span<const Vec3> from_mm,
                                                 std::span<const Vec3> to_mm,
                                                 const LeftOut& left_out) {
    const bool asked = !from_mm_.empty();
    if (asked && known_ && on_the_way(to_mm) &&
        (from_mm.data() == to_mm.data() || on_the_way(from_mm)))
        return near_;
    ++answers_;
    const Sweep sweep{from_mm, to_mm, reach_mm_ + 2.0 * same_mm_};
    std::optional<double> goes_on_mm;
    if (asked && at_its_end(from_mm)) goes_on_mm = same_mm_;
    unsorted_.clear();
    strangers_.add_between_strangers(sweep, left_out, goes_on_mm, unsorted_);
    if (!features_.beside_obstacles())  // neighbours are of one surface
        neighbours_.add_along(sweep, goes_on_mm, unsorted_);
    sort_by_feature(from_mm.size());
    from_mm_.assign(from_mm.begin(), from_mm.end());
    to_mm_.assign(to_mm.begin(), to_mm.end());
    known_ = true;
    return near_;
}

}  // namespace hepatica
