// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/step/partition.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace hepatica::gpu {
namespace {

struct Layout {
    std::vector<int> chunk_begin{0}, segment_begin{0};
    int longest = 0;

    // Appends a segment.
    void add_segment(int nodes) {
        const int first = chunk_begin.back();
        longest = std::max(longest, nodes);
        for (int done = 0; done < nodes; done += nodes_per_chunk)
            chunk_begin.push_back(first + std::min(nodes, done + nodes_per_chunk));
        segment_begin.push_back(static_cast<int>(chunk_begin.size()) - 1);
    }
};

Layout layout_of(std::span<const int> piece_of_node, int pieces) {
    std::vector<int> sizes(static_cast<std::size_t>(pieces), 0);
    for (const int piece : piece_of_node) {
        sizes.resize(std::max(sizes.size(), static_cast<std::size_t>(piece) + 1), 0);
        ++sizes[piece];
    }
    Layout layout;
    for (const int size : sizes) layout.add_segment(size);
    return layout;
}

std::vector<int> by_piece(std::span<const int> piece_of_node) {
    std::vector<int> order(piece_of_node.size());
    std::iota(order.begin(), order.end(), 0);
    if (std::ranges::is_sorted(piece_of_node)) return {};
    std::ranges::stable_sort(order, {}, [&](int i) { return piece_of_node[i]; });
    return order;
}

}  // namespace

void Partition::set(std::span<const int> piece_of_node, int pieces) {
    Layout layout = layout_of(piece_of_node, pieces);
    longest_ = layout.longest;
    partial_.resize(most_width * (layout.chunk_begin.size() - 1));
    result_.resize(most_width * (layout.segment_begin.size() - 1));
    order_.set(by_piece(piece_of_node));
    chunk_begin_.set(std::move(layout.chunk_begin));
    segment_begin_.set(std::move(layout.segment_begin));
}

}  // namespace hepatica::gpu
