// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/step/coarse_plan.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <utility>

#include "gpu/kernels/coarse_kernels.h"
#include "gpu/step/bisection.h"

namespace hepatica::gpu {
namespace {

// So many cuts a block of threads solves while others solve others, or the last one alone.
constexpr int cuts_per_row = 8, cuts_of_last_row = 24;

using Lists = std::vector<std::vector<int>>;

// Of each cut, the later ones that are coupled with it, in the matrix or by fill; ascending.
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

// A cut stands one level above the highest that is coupled with it from below.
std::vector<int> levels_of(const Lists& above) {
    std::vector<int> level(above.size(), 0);
    for (std::size_t p = 0; p < above.size(); ++p)
        for (const int i : above[p]) level[i] = std::max(level[i], level[p] + 1);
    return level;
}

// Cuts coupled with each other by the matrix.
Lists coupled_cuts(const std::vector<std::array<int, 2>>& cuts, const std::vector<int>& cut_of_node,
                   const BlockMatrix& coarse) {
    Lists coupled(cuts.size());
    for (std::size_t p = 0; p < cuts.size(); ++p)
        for (const int node : cuts[p]) {
            if (node < 0) continue;
            const int first = coarse_vectors * node;
            for (int k = coarse.row_begin[first]; k < coarse.row_begin[first + 1];
                 k += coarse_vectors)
                coupled[p].push_back(cut_of_node[coarse.column[k] / coarse_vectors]);
        }
    return coupled;
}

// Tiers of rows of cuts: subtrees of a few cuts, together with others while there is room, then the
// same of what is left, until that is small.
std::vector<Lists> tiers_of(const Lists& above) {
    const auto cuts = static_cast<int>(above.size());
    std::vector<char> left(above.size(), 1);
    std::vector<Lists> tiers;
    for (int remaining = cuts; remaining > 0;) {
        std::vector<int> size(left.begin(), left.end()), root(above.size(), -1);
        for (int p = 0; p < cuts; ++p)
            if (!above[p].empty()) size[above[p][0]] += size[p];
        const bool last = remaining <= cuts_of_last_row;
        std::map<int, std::vector<int>> subtrees;
        for (int p = cuts; p-- > 0;) {
            if (left[p] == 0 || (!last && size[p] > cuts_per_row)) continue;
            const int parent = above[p].empty() ? -1 : above[p][0];
            root[p] = last ? 0 : (parent >= 0 && root[parent] >= 0 ? root[parent] : p);
            subtrees[root[p]].push_back(p);
        }
        Lists rows;
        for (const auto& [at, members] : subtrees) {
            if (rows.empty() || (rows.back().size() + members.size() > cuts_per_row && !last))
                rows.emplace_back();
            rows.back().insert(rows.back().end(), members.begin(), members.end());
            for (const int p : members) left[p] = 0;
            remaining -= static_cast<int>(members.size());
        }
        tiers.push_back(std::move(rows));
    }
    return tiers;
}

class Planner {
  public:
    Planner(const CoarseSkeleton& skeleton, const BlockMatrix& coarse) {
        const auto cuts = bisecting_cuts(skeleton);
        std::vector<int> cut_of_node(static_cast<std::size_t>(skeleton.size()));
        for (std::size_t p = 0; p < cuts.size(); ++p)
            for (const int node : cuts[p])
                if (node >= 0) cut_of_node[node] = static_cast<int>(p);
        above_ = coupled_above(coupled_cuts(cuts, cut_of_node, coarse));
        level_ = levels_of(above_);
        place_.resize(cuts.size());
        for (Lists& tier : tiers_of(above_)) add_tier(tier);
        plan_.slot_of_node.resize(cut_of_node.size());
        for (std::size_t p = 0; p < cuts.size(); ++p)
            for (int side = 0; side < 2; ++side)
                if (cuts[p][side] >= 0) plan_.slot_of_node[cuts[p][side]] = 2 * place_[p] + side;
        set_levels();
        set_blocks();
        set_updates();
    }
    CoarsePlan plan() && { return std::move(plan_); }

  private:
    void add_tier(Lists& rows) {
        std::vector<std::vector<int>> stages_of_rows;
        CutStages tier;
        for (std::vector<int>& row : rows) {
            std::ranges::sort(row, {}, [&](int p) { return std::pair(level_[p], p); });
            std::vector<int> begin;
            for (std::size_t k = 0; k < row.size(); ++k) {
                const int at = static_cast<int>(order_.size());
                if (k == 0 || level_[row[k]] != level_[row[k - 1]] ||
                    at - begin.back() == most_cuts_of_stage)
                    begin.push_back(at);
                place_[row[k]] = at;
                order_.push_back(row[k]);
            }
            tier.stages = std::max(tier.stages, static_cast<int>(begin.size()));
            begin.push_back(static_cast<int>(order_.size()));
            stages_of_rows.push_back(std::move(begin));
        }
        for (std::vector<int>& begin : stages_of_rows) {
            begin.resize(static_cast<std::size_t>(tier.stages) + 1, begin.back());
            tier.begin.insert(tier.begin.end(), begin.begin(), begin.end());
        }
        plan_.tiers.push_back(std::move(tier));
    }

    void set_levels() {
        plan_.by_level.resize(order_.size());
        std::iota(plan_.by_level.begin(), plan_.by_level.end(), 0);
        const auto level = [&](int k) { return level_[order_[k]]; };
        std::ranges::stable_sort(plan_.by_level, {}, level);
        for (std::size_t k = 0; k < order_.size(); ++k)
            plan_.level_begin.resize(static_cast<std::size_t>(level(plan_.by_level[k])) + 1,
                                     static_cast<int>(k));
        plan_.level_begin.push_back(static_cast<int>(order_.size()));
    }

    void set_blocks() {
        plan_.column_begin = plan_.row_begin = {0};
        std::vector<std::vector<CutTerm>> in_row(order_.size());
        for (std::size_t k = 0; k < order_.size(); ++k) {
            const int own = static_cast<int>(k);
            std::vector<int> rows{own};
            for (const int i : above_[order_[k]]) rows.push_back(place_[i]);
            std::ranges::sort(rows);
            for (const int i : rows) {
                if (i != own) in_row[i].push_back({plan_.blocks(), own});
                plan_.row.push_back(i);
            }
            plan_.column_begin.push_back(plan_.blocks());
        }
        for (const auto& blocks : in_row) {
            plan_.in_row.insert(plan_.in_row.end(), blocks.begin(), blocks.end());
            plan_.row_begin.push_back(static_cast<int>(plan_.in_row.size()));
        }
    }

    void set_updates() {
        std::vector<std::vector<std::array<int, 2>>> updates(plan_.row.size());
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

    CoarsePlan plan_;
    // Of cuts in the order of bisection, but for order_, which has them by number.
    Lists above_;
    std::vector<int> level_, place_, order_;
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
