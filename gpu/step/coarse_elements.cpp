// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/step/coarse_elements.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <utility>

namespace hepatica::gpu {
namespace {

class ElementPlanner {
  public:
    ElementPlanner(std::span<const std::array<int, 2>> nodes, const AssemblyPlan& plan,
                   std::span<const NodePair> pairs)
        : nodes_(nodes), plan_(plan) {
        for (std::size_t q = 0; q < pairs.size(); ++q)
            pair_of_[{pairs[q].own, pairs[q].other}] = static_cast<int>(q);
        parts_.resize(pairs.size());
        elements_.vertex.resize(nodes.size());
        std::iota(elements_.vertex.begin(), elements_.vertex.end(), 0);
        std::ranges::stable_sort(elements_.vertex, {}, [&](int v) { return nodes_[v]; });
        for (int begin = 0, end; begin < count(); begin = end) {
            for (end = begin + 1; end < count() && end - begin < CoarseElement::most_vertices &&
                                  between(end) == between(begin);)
                ++end;
            add(begin, end);
        }
        elements_.part_begin = {0};
        for (const std::vector<int>& parts : parts_) {
            elements_.part.insert(elements_.part.end(), parts.begin(), parts.end());
            elements_.part_begin.push_back(static_cast<int>(elements_.part.size()));
        }
    }
    CoarseElements elements() && { return std::move(elements_); }

  private:
    int count() const { return static_cast<int>(nodes_.size()); }
    const std::array<int, 2>& between(int place) const { return nodes_[elements_.vertex[place]]; }

    // The nodes that move these vertices or their neighbours and form a pair with one of their
    // nodes.
    std::set<int> others_of(int begin, int end) const {
        std::set<int> others;
        for (int place = begin; place < end; ++place) {
            const int v = elements_.vertex[place];
            for (int k = plan_.row_begin[v]; k < plan_.row_begin[v + 1]; ++k)
                for (const int other : nodes_[plan_.column[k]])
                    if (pair_of_.contains({between(begin)[0], other}) ||
                        pair_of_.contains({between(begin)[1], other}))
                        others.insert(other);
        }
        return others;
    }

    // Adds as many elements for these vertices as their other nodes need.
    void add(int begin, int end) {
        const std::set<int> others = others_of(begin, end);
        const auto [first, second] = between(begin);
        for (auto other = others.begin(); other != others.end();) {
            CoarseElement element{begin, end - begin, {first, second}, {-1, -1, -1, -1}, 0u};
            for (int k = 0; k < CoarseElement::most_others && other != others.end(); ++k, ++other)
                element.other[k] = *other;
            const int number = static_cast<int>(elements_.element.size());
            // Where both nodes are the same, its parts exist once.
            for (int side = 0; side < (first == second ? 1 : 2); ++side)
                for (int k = 0; k < CoarseElement::most_others; ++k) {
                    const auto pair = pair_of_.find({element.own[side], element.other[k]});
                    if (pair == pair_of_.end()) continue;
                    parts_[pair->second].push_back(CoarseElement::part(number, side, k));
                    element.wanted |= 1u << (side * CoarseElement::most_others + k);
                }
            elements_.element.push_back(element);
        }
    }

    std::span<const std::array<int, 2>> nodes_;
    const AssemblyPlan& plan_;
    std::map<std::pair<int, int>, int> pair_of_;
    std::vector<std::vector<int>> parts_;  // of each pair
    CoarseElements elements_;
};

}  // namespace

CoarseElements plan_coarse_elements(std::span<const std::array<int, 2>> nodes,
                                    const AssemblyPlan& plan, std::span<const NodePair> pairs) {
    return ElementPlanner(nodes, plan, pairs).elements();
}

}  // namespace hepatica::gpu
