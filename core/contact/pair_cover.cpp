// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/pair_cover.h"

#include <algorithm>
#include <cmath>

#include "core/base/parallel.h"

namespace hepatica {
namespace {

constexpr std::size_t pairs_per_block = 4096;

}  // namespace

std::size_t PairCover::bytes() const {
    return pairs_.capacity() * sizeof(FeaturePair) +
           (begin_mm_.capacity() + motion_mm_.capacity()) * sizeof(Vec3) +
           beside_mm_.capacity() * sizeof(double);
}

// How far along the motion of the search these places are, by least squares.
double PairCover::share_at(std::span<const Vec3> positions_mm) const {
    if (motion_squared_mm2_ == 0.0) return 0.0;
    double along = 0.0;
    for (const int v : features_.nodes())
        along += motion_mm_[v].dot(positions_mm[v] - begin_mm_[v]);
    return std::clamp(along / motion_squared_mm2_, 0.0, 1.0);
}

// Also notes how far each vertex is beside its place on the motion.
bool PairCover::covers(std::span<const Vec3> positions_mm, double share) {
    bool near = true;
    for (const int v : features_.nodes()) {
        const double beside = (positions_mm[v] - begin_mm_[v] - share * motion_mm_[v]).norm();
        near = near && beside <= slack_mm_;
        beside_mm_[v] = std::max(beside_mm_[v], beside);
    }
    return near;
}

void PairCover::search(std::span<const Vec3> from_mm, std::span<const Vec3> to_mm,
                       const LeftOut& left_out) {
    ++searches_;
    begin_mm_.assign(from_mm.begin(), from_mm.end());
    motion_mm_.assign(to_mm.begin(), to_mm.end());
    motion_squared_mm2_ = 0.0;
    for (std::size_t i = 0; i < motion_mm_.size(); ++i) motion_mm_[i] -= from_mm[i];
    for (const int v : features_.nodes()) motion_squared_mm2_ += motion_mm_[v].squaredNorm();
    beside_mm_.assign(from_mm.size(), 0.0);
    pairs_ = search_.along(from_mm, to_mm, reach_mm_ + 2.0 * slack_mm_, left_out);
}

std::vector<FeaturePair> PairCover::along(std::span<const Vec3> from_mm,
                                          std::span<const Vec3> to_mm, const LeftOut& left_out) {
    double share = 1.0;
    bool covered = !begin_mm_.empty();
    if (covered) {
        std::ranges::fill(beside_mm_, 0.0);
        share = share_at(to_mm);
        covered = covers(to_mm, share);
        if (covered && from_mm.data() != to_mm.data()) {
            const double first = share_at(from_mm);
            covered = covers(from_mm, first);
            share = std::max(share, first);
        }
    }
    if (!covered) {
        share = 1.0;
        search(from_mm, to_mm, left_out);
    }
    const std::size_t blocks = (pairs_.size() + pairs_per_block - 1) / pairs_per_block;
    std::vector<std::vector<FeaturePair>> near(blocks);
    parallel_blocks(pairs_.size(), pairs_per_block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) {
            const FeaturePair& pair = pairs_[k];
            const auto& n = pair.nodes;
            const double a = beside_mm_[n[0]], b = beside_mm_[n[1]], c = beside_mm_[n[2]],
                         d = beside_mm_[n[3]];
            const double beside =
                pair.of_edges ? std::max(a, b) + std::max(c, d) : a + std::max({b, c, d});
            if (pair.apart_mm - share * pair.approach_mm - beside <= reach_mm_)
                near[begin / pairs_per_block].push_back(pair);
        }
    });
    std::vector<FeaturePair> all;
    for (const auto& some : near) all.insert(all.end(), some.begin(), some.end());
    return all;
}

}  // namespace hepatica
