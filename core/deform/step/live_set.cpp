// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/step/live_set.h"

#include <algorithm>
#include <iterator>
#include <numeric>

namespace hepatica {

LiveSet::LiveSet(const Body& body) : body_(body), packs_(body.groups.size()) {
    begin_again();
}

void LiveSet::begin_again() {
    held_ = body_.fixed;
    find_rows_and_packs(std::vector<std::uint8_t>(held_.size(), 0));
    forget_written();
}

void LiveSet::forget_written() {
    changed_.resize(held_.size());
    std::iota(changed_.begin(), changed_.end(), 0);
}

void LiveSet::freeze(std::span<const std::uint8_t> frozen) {
    for (std::size_t i = 0; i < held_.size(); ++i)
        held_[i] = body_.fixed[i] != 0 || frozen[i] != 0 ? 1 : 0;
    const std::vector<int> before = changed_;
    find_rows_and_packs(frozen);
    changed_.clear();
    std::ranges::set_union(before, rows_, std::back_inserter(changed_));
}

void LiveSet::find_rows_and_packs(std::span<const std::uint8_t> frozen) {
    std::vector<std::uint8_t> touched(held_.size(), 0);
    live_elements_ = 0;
    for (std::size_t g = 0; g < body_.groups.size(); ++g) {
        const ElementGroup& group = body_.groups[g];
        packs_[g].clear();
        for (int e = 0; e < group.size(); ++e) {
            const auto nodes = std::span(group.connectivity)
                                   .subspan(static_cast<std::size_t>(e) * group.nodes_per_element,
                                            group.nodes_per_element);
            live_elements_ += std::ranges::any_of(nodes, [&](int i) { return frozen[i] == 0; });
            if (std::ranges::all_of(nodes, [&](int i) { return held_[i] != 0; })) continue;
            const int pack = e / elements_per_pack;
            if (packs_[g].empty() || packs_[g].back() != pack) packs_[g].push_back(pack);
            for (const int i : nodes) touched[i] = 1;
        }
    }
    rows_.clear();
    for (std::size_t i = 0; i < touched.size(); ++i)
        if (touched[i]) rows_.push_back(static_cast<int>(i));
}

}  // namespace hepatica
