// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/step/coarse_plan.h"

#include <algorithm>
#include <numeric>
#include <set>

#include "gpu/kernels/coarse_kernels.h"
#include "gpu/step/bisection.h"

namespace hepatica::gpu {
namespace {

// A block of threads solves so many cuts while others solve others; fewer in all need no others.
constexpr int cuts_per_subtree = 32;

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

class Planner {
  public:
    Planner(const CoarseSkeleton& skeleton, const BlockMatrix& coarse) {
        const auto cuts = bisecting_cuts(skeleton);
        std::vector<int> cut_of_node(static_cast<std::size_t>(skeleton.size()));
        for (std::size_t p = 0; p < cuts.size(); ++p)
            for (const int node : cuts[p])
                if (node >= 0) cut_of_node[node] = static_cast<int>(p);
        const Lists above = coupled_above(coupled_cuts(cuts, cut_of_node, coarse));
        number_by_level(cuts, above);
        set_blocks(above);
        set_updates();
        set_stages();
    }
    CoarsePlan plan() && { return std::move(plan_); }

  private:
    void number_by_level(const std::vector<std::array<int, 2>>& cuts, const Lists& above) {
        const std::vector<int> level = levels_of(above);
        order_.resize(cuts.size());
        std::iota(order_.begin(), order_.end(), 0);
        std::ranges::stable_sort(order_, {}, [&](int p) { return level[p]; });
        place_.resize(cuts.size());
        plan_.slot_of_node.resize(2 * cuts.size(), -1);
        int nodes = 0;
        for (std::size_t k = 0; k < order_.size(); ++k) {
            const int p = order_[k], at = static_cast<int>(k);
            place_[p] = at;
            plan_.level_begin.resize(static_cast<std::size_t>(level[p]) + 1, at);
            for (int side = 0; side < 2; ++side)
                if (cuts[p][side] >= 0) {
                    plan_.slot_of_node[cuts[p][side]] = 2 * at + side;
                    ++nodes;
                }
        }
        plan_.level_begin.push_back(static_cast<int>(cuts.size()));
        plan_.slot_of_node.resize(static_cast<std::size_t>(nodes));
    }

    void set_blocks(const Lists& above) {
        plan_.column_begin = plan_.row_begin = {0};
        Lists in_row(order_.size());
        for (std::size_t k = 0; k < order_.size(); ++k) {
            const int own = static_cast<int>(k);
            std::vector<int> rows{own};
            for (const int i : above[order_[k]]) rows.push_back(place_[i]);
            std::ranges::sort(rows);
            for (const int i : rows) {
                if (i != own) in_row[i].push_back(plan_.blocks());
                plan_.row.push_back(i);
                plan_.column.push_back(own);
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

    // The root of the largest subtree of at most so many cuts that each cut belongs to; -1: none.
    std::vector<int> subtrees() const {
        const auto parent = [&](int p) {
            const int own = plan_.column_begin[p];
            return own + 1 < plan_.column_begin[p + 1] ? plan_.row[own + 1] : -1;
        };
        std::vector<int> size(order_.size(), 1), root(order_.size(), -1);
        if (plan_.cuts() <= 2 * cuts_per_subtree) return root;
        for (int p = 0; p < plan_.cuts(); ++p)
            if (parent(p) >= 0) size[parent(p)] += size[p];
        for (int p = plan_.cuts(); p-- > 0;) {
            if (size[p] > cuts_per_subtree) continue;
            const bool whole = parent(p) < 0 || root[parent(p)] < 0;
            root[p] = whole ? p : root[parent(p)];
        }
        return root;
    }

    // Subtrees share a row while it has room.
    void set_stages() {
        const std::vector<int> root = subtrees();
        std::vector<int> size(order_.size(), 0), row_of(order_.size(), -1);
        for (const int r : root)
            if (r >= 0) ++size[r];
        Lists below;
        for (std::size_t r = 0; r < size.size(); ++r) {
            if (size[r] == 0) continue;
            if (below.empty() || static_cast<int>(below.back().size()) + size[r] > cuts_per_subtree)
                below.emplace_back();
            for (std::size_t p = 0; p <= r; ++p)
                if (root[p] == static_cast<int>(r)) below.back().push_back(static_cast<int>(p));
        }
        std::vector<int> top;
        for (std::size_t p = 0; p < root.size(); ++p)
            if (root[p] < 0) top.push_back(static_cast<int>(p));
        plan_.below = stages_of(below);
        plan_.top = stages_of({top});
    }

    CutStages stages_of(const Lists& rows) const {
        CutStages all;
        std::vector<Lists> by_row;
        for (const auto& row : rows) {
            by_row.push_back(by_level(row));
            all.stages = std::max(all.stages, static_cast<int>(by_row.back().size()));
        }
        for (Lists& stages : by_row) {
            stages.resize(static_cast<std::size_t>(all.stages));
            for (const auto& stage : stages) {
                all.begin.push_back(static_cast<int>(all.cut.size()));
                all.cut.insert(all.cut.end(), stage.begin(), stage.end());
            }
            all.begin.push_back(static_cast<int>(all.cut.size()));
        }
        return all;
    }
    // Those of one level together, without levels that have none.
    Lists by_level(std::vector<int> cuts) const {
        const auto level = [&](int p) {
            return std::ranges::upper_bound(plan_.level_begin, p) - plan_.level_begin.begin();
        };
        std::ranges::sort(cuts);
        Lists stages;
        for (std::size_t k = 0; k < cuts.size(); ++k) {
            if (k == 0 || level(cuts[k]) != level(cuts[k - 1]) ||
                stages.back().size() == most_cuts_of_stage)
                stages.emplace_back();
            stages.back().push_back(cuts[k]);
        }
        return stages;
    }

    CoarsePlan plan_;
    std::vector<int> order_, place_;  // cuts by number, and the number of each
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
