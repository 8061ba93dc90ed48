// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/step/coarse_plan.h"

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <set>
#include <utility>

#include "gpu/kernels/coarse_kernels.h"
#include "gpu/step/bisection.h"

namespace hepatica::gpu {
namespace {

using Lists = std::vector<std::vector<int>>;

// For each cut, the later cuts that are coupled with it, by the matrix or by fill-in; ascending.
// Symbolic factorisation along the elimination tree.
Lists coupled_above(const Lists& coupled) {
    std::vector<std::set<int>> above(coupled.size());
    for (std::size_t p = 0; p < coupled.size(); ++p) {
        above[p].insert(coupled[p].begin(), coupled[p].end());
        above[p].erase(above[p].begin(), above[p].upper_bound(static_cast<int>(p)));
        if (above[p].empty()) continue;
        const int parent = *above[p].begin();
        above[parent].insert(std::next(above[p].begin()), above[p].end());
    }
    Lists lists;
    for (const auto& one : above) lists.emplace_back(one.begin(), one.end());
    return lists;
}

// The level of a cut is one above the highest lower cut that is coupled with it.
std::vector<int> levels_of(const Lists& above) {
    std::vector<int> level(above.size(), 0);
    for (std::size_t p = 0; p < above.size(); ++p)
        for (const int i : above[p]) level[i] = std::max(level[i], level[p] + 1);
    return level;
}

// Nodes that the matrix couples; each has four rows.
Couplings couplings_of(const BlockMatrix& coarse) {
    Couplings coupled(coarse.row_begin.size() / coarse_vectors);
    for (std::size_t n = 0; n < coupled.size(); ++n)
        for (int k = coarse.row_begin[coarse_vectors * n];
             k < coarse.row_begin[coarse_vectors * n + 1]; k += coarse_vectors)
            coupled[n].push_back(coarse.column[k] / coarse_vectors);
    return coupled;
}

// Cuts that the matrix couples.
Lists coupled_cuts(const std::vector<std::array<int, 2>>& cuts, const std::vector<int>& cut_of_node,
                   const Couplings& nodes) {
    Lists coupled(cuts.size());
    for (std::size_t p = 0; p < cuts.size(); ++p)
        for (const int node : cuts[p])
            for (std::size_t k = 0; node >= 0 && k < nodes[node].size(); ++k)
                coupled[p].push_back(cut_of_node[nodes[node][k]]);
    return coupled;
}

// Sorts 0, 1, ... by level, and finds where each of the `levels` levels begins.
void sort_by_level(const std::vector<int>& level, int levels, std::vector<int>& by_level,
                   std::vector<int>& begin) {
    by_level.resize(level.size());
    std::iota(by_level.begin(), by_level.end(), 0);
    std::ranges::stable_sort(by_level, {}, [&](int k) { return level[k]; });
    begin.assign(static_cast<std::size_t>(levels) + 1, 0);
    for (const int one : level) ++begin[one + 1];
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
}

class Planner {
  public:
    Planner(const CoarseSkeleton& skeleton, const BlockMatrix& coarse) {
        const Couplings coupled = couplings_of(coarse);
        const auto cuts = bisecting_cuts(skeleton, coupled);
        std::vector<int> cut_of_node(static_cast<std::size_t>(skeleton.size()));
        for (std::size_t p = 0; p < cuts.size(); ++p)
            for (const int node : cuts[p])
                if (node >= 0) cut_of_node[node] = static_cast<int>(p);
        above_ = coupled_above(coupled_cuts(cuts, cut_of_node, coupled));
        level_ = levels_of(above_);
        plan_.slot_of_node.resize(cut_of_node.size());
        for (std::size_t p = 0; p < cuts.size(); ++p)
            for (int side = 0; side < 2; ++side)
                if (cuts[p][side] >= 0)
                    plan_.slot_of_node[cuts[p][side]] = 2 * static_cast<int>(p) + side;
        set_blocks();
        sort_by_level(level_, levels(), plan_.by_level, plan_.level_begin);
        set_updates();
        set_inverse();
    }
    CoarsePlan plan() && { return std::move(plan_); }

  private:
    int levels() const { return level_.empty() ? 0 : *std::ranges::max_element(level_) + 1; }

    void set_blocks() {
        plan_.column_begin = {0};
        for (std::size_t p = 0; p < above_.size(); ++p) {
            plan_.row.push_back(static_cast<int>(p));
            plan_.row.insert(plan_.row.end(), above_[p].begin(), above_[p].end());
            plan_.column_begin.push_back(plan_.blocks());
        }
    }

    void set_updates() {
        std::vector<std::vector<CutListsView::Update>> updates(plan_.row.size());
        for (int k = 0; k < plan_.cuts(); ++k)
            for (int b = plan_.column_begin[k] + 1; b < plan_.column_begin[k + 1]; ++b)
                for (int a = b; a < plan_.column_begin[k + 1]; ++a)
                    updates[plan_.find(plan_.row[a], plan_.row[b])].push_back({a, b});
        plan_.update_begin = {0};
        for (const auto& one : updates) {
            plan_.update.insert(plan_.update.end(), one.begin(), one.end());
            plan_.update_begin.push_back(static_cast<int>(plan_.update.size()));
        }
    }

    // The ancestors of a cut in the elimination tree, nearest first: N^-1 has a block for each.
    std::vector<int> path_from(int cut) const {
        std::vector<int> path;
        while (!above_[cut].empty()) path.push_back(cut = above_[cut][0]);
        return path;
    }

    void set_inverse() {
        InversePlan& inverse = plan_.inverse;
        const auto cuts = static_cast<int>(above_.size());
        Lists below(above_.size());
        for (int p = 0; p < cuts; ++p)
            for (const int i : path_from(p)) below[i].push_back(p);
        std::map<std::pair<int, int>, int> block_at;  // by row and column
        std::vector<int> level;
        for (int i = 0; i < cuts; ++i) {
            for (std::size_t k = 0; k < below[i].size(); ++k) {
                if (k % SumBelow<float>::most_blocks == 0 && k > 0)
                    inverse.chunk_begin.push_back(static_cast<int>(inverse.column.size()));
                block_at[{i, below[i][k]}] = static_cast<int>(inverse.column.size());
                inverse.column.push_back(below[i][k]);
                level.push_back(levels() - 1 - level_[below[i][k]]);
            }
            if (!below[i].empty())
                inverse.chunk_begin.push_back(static_cast<int>(inverse.column.size()));
            inverse.first_chunk.push_back(static_cast<int>(inverse.chunk_begin.size()) - 1);
        }
        sort_by_level(level, levels(), inverse.by_level, inverse.level_begin);
        for (const auto& [place, block] : block_at)
            add_products(place.first, place.second, block_at);
        for (int p = 0; p < cuts; ++p) {
            for (const int i : path_from(p)) inverse.above.push_back({block_at.at({i, p}), i});
            inverse.above_begin.push_back(static_cast<int>(inverse.above.size()));
        }
    }

    // From N^-1 N = 1: block (i, p) is minus the sum of (N^-1)_ik N_kp over p < k <= i.
    void add_products(int i, int p, const std::map<std::pair<int, int>, int>& block_at) {
        InversePlan& inverse = plan_.inverse;
        for (int b = plan_.column_begin[p] + 1; b < plan_.column_begin[p + 1]; ++b) {
            const int k = plan_.row[b];
            if (k == i)
                inverse.product.push_back({-1, b});
            else if (const auto left = block_at.find({i, k}); left != block_at.end())
                inverse.product.push_back({left->second, b});
        }
        inverse.product_begin.push_back(static_cast<int>(inverse.product.size()));
    }

    CoarsePlan plan_;
    Lists above_;
    std::vector<int> level_;
};

}  // namespace

int CoarsePlan::find(int row_cut, int column_cut) const {
    const auto begin = row.begin() + column_begin[column_cut];
    const auto end = row.begin() + column_begin[column_cut + 1];
    const auto found = std::lower_bound(begin, end, row_cut);
    return found != end && *found == row_cut ? static_cast<int>(found - row.begin()) : -1;
}

CoarsePlan plan_coarse(const CoarseSkeleton& skeleton, const BlockMatrix& coarse) {
    return Planner(skeleton, coarse).plan();
}

}  // namespace hepatica::gpu
