// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/pair_cover.h"

#include <algorithm>
#include <cmath>

namespace hepatica {
namespace {

constexpr double margin_slacks = 4.0;  // of boxes in the tree
constexpr double same_slacks = 0.01;   // places no farther apart are the same one

}  // namespace

PairCover::PairCover(const SurfaceFeatures& features, double reach_mm, double slack_mm)
    : features_(features),
      strangers_(features, margin_slacks * slack_mm),
      neighbours_(features, strangers_, slack_mm),
      reach_mm_(reach_mm),
      same_mm_(same_slacks * slack_mm) {}

std::size_t PairCover::bytes() const {
    return near_.capacity() * sizeof(FeaturePair) +
           (from_mm_.capacity() + to_mm_.capacity()) * sizeof(Vec3) + neighbours_.bytes();
}

// Whether all vertices are equally far along the last motion, by least squares.
bool PairCover::on_the_way(std::span<const Vec3> positions_mm) const {
    double along = 0.0, whole = 0.0;
    for (const int v : features_.nodes()) {
        const Vec3 motion = to_mm_[v] - from_mm_[v];
        along += motion.dot(positions_mm[v] - from_mm_[v]);
        whole += motion.squaredNorm();
    }
    const double share = whole > 0.0 ? std::clamp(along / whole, 0.0, 1.0) : 0.0;
    return std::ranges::all_of(features_.nodes(), [&](int v) {
        const Vec3 there = from_mm_[v] + share * (to_mm_[v] - from_mm_[v]);
        return (positions_mm[v] - there).squaredNorm() <= same_mm_ * same_mm_;
    });
}

bool PairCover::at_its_end(std::span<const Vec3> positions_mm) const {
    return std::ranges::all_of(features_.nodes(), [&](int v) {
        return (positions_mm[v] - to_mm_[v]).squaredNorm() <= same_mm_ * same_mm_;
    });
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
    const bool goes_on = asked && at_its_end(from_mm);
    near_.clear();
    strangers_.add_between_strangers(sweep, left_out, near_);
    if (!features_.beside_obstacles())  // neighbours are of one surface
        neighbours_.add_along(sweep, goes_on ? std::optional(same_mm_) : std::nullopt, near_);
    from_mm_.assign(from_mm.begin(), from_mm.end());
    to_mm_.assign(to_mm.begin(), to_mm.end());
    known_ = true;
    return near_;
}

}  // namespace hepatica
