// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/neighbour_pairs.h"

#include "core/base/parallel.h"

namespace hepatica {
namespace {

constexpr std::size_t clusters_per_block = 16;

}  // namespace

NeighbourPairs::NeighbourPairs(const SurfaceFeatures& features, double slack_mm)
    : features_(features), slack_mm_(slack_mm) {
    for (int p = 0; p < static_cast<int>(features.surface().size()); ++p) {
        std::vector<int> others{p};
        const auto above = features.neighbours_above(p);
        others.insert(others.end(), above.begin(), above.end());
        clusters_.emplace_back(features, p, std::move(others));
    }
}

int NeighbourPairs::searches() const {
    int sum = 0;
    for (const ClusterPairs& cluster : clusters_) sum += cluster.searches();
    return sum;
}

std::size_t NeighbourPairs::bytes() const {
    std::size_t sum = 0;
    for (const ClusterPairs& cluster : clusters_) sum += cluster.bytes();
    return sum;
}

void NeighbourPairs::add_along(const Sweep& sweep, std::optional<double> goes_on_mm,
                               std::vector<FeaturePair>& found) {
    const std::size_t blocks = (clusters_.size() + clusters_per_block - 1) / clusters_per_block;
    std::vector<std::vector<FeaturePair>> found_in(blocks);
    parallel_blocks(clusters_.size(), clusters_per_block, [&](std::size_t begin, std::size_t end) {
        PatchPairSearch search(features_);
        for (std::size_t c = begin; c < end; ++c)
            clusters_[c].add_along(sweep, slack_mm_, goes_on_mm, search,
                                   found_in[begin / clusters_per_block]);
    });
    for (const auto& some : found_in) found.insert(found.end(), some.begin(), some.end());
}

}  // namespace hepatica
