// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/step/assembly_plan.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>

#include "core/base/error.h"

namespace hepatica {
namespace {

using Kind = ElementGroup::Kind;
using small::Tangent;

// Whether all elements have the same ratio lambda / mu, which is also that of the groups before.
bool has_one_ratio(const ElementGroup& group, double& lambda_over_mu) {
    for (const auto& rest : group.tetrahedra) {
        if (lambda_over_mu == 0.0) lambda_over_mu = rest.lambda / rest.mu;
        if (std::abs(rest.lambda / rest.mu - lambda_over_mu) > 1e-12 * lambda_over_mu) return false;
    }
    return true;
}

void lay_out_slots(const Body& body, Tangent tangent, AssemblyPlan& plan) {
    std::size_t forces = 0, blocks = 0;
    for (const ElementGroup& group : body.groups) {
        GroupSlots own;
        own.four_at_a_time =
            body.model == ElementModel::corotated && tangent == Tangent::rotated &&
            (group.kind == Kind::linear_tetrahedron || group.kind == Kind::quadratic_tetrahedron);
        own.in_factors = own.four_at_a_time && group.kind == Kind::linear_tetrahedron &&
                         has_one_ratio(group, plan.lambda_over_mu);
        own.first_force = forces;
        own.first_block = blocks;
        forces += group.connectivity.size();
        if (!own.in_factors)
            blocks +=
                static_cast<std::size_t>(group.size()) * static_cast<std::size_t>(group.pairs());
        plan.groups.push_back(own);
    }
    if (std::max(forces, blocks) > static_cast<std::size_t>(std::numeric_limits<int>::max()))
        throw InputError("the body has too many elements", "elements", "Use a coarser mesh");
    plan.force_slots = static_cast<int>(forces);
    plan.block_slots = static_cast<int>(blocks);
}

int find(const AssemblyPlan& plan, int i, int j) {
    const auto first = plan.column.begin() + plan.row_begin[i];
    const auto last = plan.column.begin() + plan.row_begin[i + 1];
    return static_cast<int>(std::lower_bound(first, last, j) - plan.column.begin());
}

// The force slots of each node, in the order of the elements.
void list_forces(const Body& body, AssemblyPlan& plan) {
    plan.forces.begin.assign(static_cast<std::size_t>(body.node_count()) + 1, 0);
    for (const ElementGroup& group : body.groups)
        for (const int node : group.connectivity) ++plan.forces.begin[node + 1];
    for (int i = 0; i < body.node_count(); ++i) plan.forces.begin[i + 1] += plan.forces.begin[i];
    plan.forces.place.resize(static_cast<std::size_t>(plan.force_slots));
    std::vector<int> next = plan.forces.begin;
    int slot = 0;
    for (const ElementGroup& group : body.groups)
        for (const int node : group.connectivity) plan.forces.place[next[node]++] = slot++;
}

// One block row of the matrix: its columns, and the gather lists of the blocks right of the
// diagonal.
class RowPlan {
  public:
    RowPlan(const Body& body, const AssemblyPlan& plan)
        : body_(body), plan_(plan), parted_with_(parted_with(body)) {}

    void find(int row) {
        columns_.assign(1, row);
        if (!parted_with_.empty())
            columns_.insert(columns_.end(), parted_with_[row].begin(), parted_with_[row].end());
        for_each_neighbour(row, [&](const Neighbour& other) { columns_.push_back(other.node); });
        std::ranges::sort(columns_);
        columns_.erase(std::unique(columns_.begin(), columns_.end()), columns_.end());
    }
    const std::vector<int>& columns() const { return columns_; }

    // Appends the lists of the row of the last find().
    void append_lists(int row, AssemblyPlan& plan) {
        for (auto* lists : {&factors_, &blocks_, &transposed_}) lists->clear();
        for_each_neighbour(row, [&](const Neighbour& other) {
            if (other.node < row) return;
            const int place =
                static_cast<int>(std::ranges::lower_bound(columns_, other.node) - columns_.begin());
            const GroupSlots& slots = plan_.groups[other.group];
            if (slots.in_factors) {
                factors_.push_back({place, other.own_slot});
                factors_.push_back({place, other.slot});
            } else {
                (other.turned ? transposed_ : blocks_).push_back({place, other.block_slot});
            }
        });
        append(factors_, plan.factors);
        append(blocks_, plan.blocks);
        append(transposed_, plan.transposed);
    }

  private:
    // Another node of an element of the row's node.
    struct Neighbour {
        int node;
        std::size_t group;
        int own_slot;
        int slot;
        int block_slot;  // block of the pair (row, node)
        bool turned;     // the block was written for (node, row)
    };

    static std::vector<std::vector<int>> parted_with(const Body& body) {
        std::vector<std::vector<int>> others;
        if (body.parted_pairs.empty()) return others;
        others.resize(static_cast<std::size_t>(body.node_count()));
        for (const auto& [i, j] : body.parted_pairs) {
            others[i].push_back(j);
            others[j].push_back(i);
        }
        return others;
    }

    template <class Visit>
    void for_each_neighbour(int row, const Visit& visit) const {
        for (int s = plan_.forces.begin[row]; s < plan_.forces.begin[row + 1]; ++s) {
            const int slot = plan_.forces.place[s];
            std::size_t g = 0;
            while (g + 1 < plan_.groups.size() &&
                   slot >= static_cast<int>(plan_.groups[g + 1].first_force))
                ++g;
            const ElementGroup& group = body_.groups[g];
            const int n = group.nodes_per_element;
            const int local = slot - static_cast<int>(plan_.groups[g].first_force);
            const int element = local / n, own = local % n;
            const int* nodes = group.connectivity.data() + static_cast<std::ptrdiff_t>(element) * n;
            const int first_block = plan_.block_slot(g, element, group.pairs());
            for (int a = 0; a < n; ++a) {
                if (a == own) continue;
                const int low = std::min(a, own), high = std::max(a, own);
                const int pair = low * n - low * (low + 1) / 2 + high - low - 1;
                visit(Neighbour{nodes[a], g, slot, slot - own + a, first_block + pair, a < own});
            }
        }
    }

    // Entries with the same place keep their order.
    void append(const std::vector<std::array<int, 2>>& entries, GatherLists& lists) const {
        const std::size_t first = lists.begin.size() - 1;
        const int before = lists.begin.back();
        lists.begin.resize(lists.begin.size() + columns_.size(), 0);
        for (const auto& entry : entries) ++lists.begin[first + 1 + entry[0]];
        for (std::size_t k = first + 1; k < lists.begin.size(); ++k)
            lists.begin[k] += k == first + 1 ? before : lists.begin[k - 1];
        lists.place.resize(static_cast<std::size_t>(lists.begin.back()));
        std::vector<int> next(lists.begin.begin() + static_cast<std::ptrdiff_t>(first),
                              lists.begin.end() - 1);
        for (const auto& [place, slot] : entries) lists.place[next[place]++] = slot;
    }

    const Body& body_;
    const AssemblyPlan& plan_;
    std::vector<std::vector<int>> parted_with_;  // for each node; empty where nothing has parted
    std::vector<int> columns_;
    std::vector<std::array<int, 2>> factors_, blocks_, transposed_;
};

// Appends the row of the last find().
void append_row(int i, RowPlan& row, AssemblyPlan& plan) {
    const auto& columns = row.columns();
    plan.diagonal.push_back(static_cast<int>(
        plan.column.size() + (std::ranges::lower_bound(columns, i) - columns.begin())));
    plan.column.insert(plan.column.end(), columns.begin(), columns.end());
    plan.row_begin.push_back(static_cast<int>(plan.column.size()));
    row.append_lists(i, plan);
}

// Lays out row after row, each from the elements of its node.
void lay_out_rows(const Body& body, AssemblyPlan& plan) {
    list_forces(body, plan);
    RowPlan row(body, plan);
    for (int i = 0; i < body.node_count(); ++i) {
        row.find(i);
        append_row(i, row, plan);
    }
    plan.mirror.resize(plan.column.size());
    for (int i = 0; i < body.node_count(); ++i)
        for (int k = plan.diagonal[i]; k < plan.row_begin[i + 1]; ++k) {
            const int other = find(plan, plan.column[k], i);
            plan.mirror[k] = other;
            plan.mirror[other] = k;
        }
}

// The nodes whose elements, or the nodes they parted from, differ between the two bodies.
std::vector<std::uint8_t> changed_nodes(const Body& before, const Body& body) {
    std::vector<std::uint8_t> changed(static_cast<std::size_t>(body.node_count()), 0);
    const auto mark = [&](int node) {
        if (node < body.node_count()) changed[node] = 1;
    };
    for (int i = before.node_count(); i < body.node_count(); ++i) mark(i);
    for (std::size_t g = 0; g < body.groups.size(); ++g) {
        const ElementGroup& group = body.groups[g];
        const auto n = static_cast<std::size_t>(group.nodes_per_element);
        const int *then = before.groups[g].connectivity.data(), *now = group.connectivity.data();
        for (std::size_t e = 0; e < group.connectivity.size(); e += n) {
            if (std::equal(now + e, now + e + n, then + e)) continue;
            std::for_each(then + e, then + e + n, mark);
            std::for_each(now + e, now + e + n, mark);
        }
    }
    std::vector<std::array<int, 2>> pairs;
    std::ranges::set_symmetric_difference(before.parted_pairs, body.parted_pairs,
                                          std::back_inserter(pairs));
    for (const auto& [i, j] : pairs) {
        mark(i);
        mark(j);
    }
    return changed;
}

// Reserves the size of another vector plus a margin.
void make_room_as(const std::vector<int>& other, std::vector<int>& values) {
    values.reserve(other.size() + other.size() / 16);
}

void make_room_as(const AssemblyPlan& other, AssemblyPlan& plan) {
    make_room_as(other.row_begin, plan.row_begin);
    make_room_as(other.column, plan.column);
    make_room_as(other.diagonal, plan.diagonal);
    make_room_as(other.factors.begin, plan.factors.begin);
    make_room_as(other.factors.place, plan.factors.place);
    make_room_as(other.blocks.begin, plan.blocks.begin);
    make_room_as(other.blocks.place, plan.blocks.place);
    make_room_as(other.transposed.begin, plan.transposed.begin);
    make_room_as(other.transposed.place, plan.transposed.place);
}

// Appends the entries begin[first] to begin[last] of the lists.
void take_lists(const GatherLists& from, int first, int last, GatherLists& lists) {
    const int shift = lists.begin.back() - from.begin[first];
    for (int k = first; k < last; ++k) lists.begin.push_back(from.begin[k + 1] + shift);
    lists.place.insert(lists.place.end(), from.place.begin() + from.begin[first],
                       from.place.begin() + from.begin[last]);
}

// Appends the rows first_row ... last_row - 1 unchanged.
void take_rows(const AssemblyPlan& from, int first_row, int last_row, AssemblyPlan& plan) {
    const int first = from.row_begin[first_row], last = from.row_begin[last_row];
    const int shift = static_cast<int>(plan.column.size()) - first;
    for (int i = first_row; i < last_row; ++i) {
        plan.diagonal.push_back(from.diagonal[i] + shift);
        plan.row_begin.push_back(from.row_begin[i + 1] + shift);
    }
    plan.column.insert(plan.column.end(), from.column.begin() + first, from.column.begin() + last);
    take_lists(from.factors, first, last, plan.factors);
    take_lists(from.blocks, first, last, plan.blocks);
    take_lists(from.transposed, first, last, plan.transposed);
}

// A block between two rows that were copied keeps its index within its row.
void take_mirror(const AssemblyPlan& from, const std::vector<std::uint8_t>& changed,
                 AssemblyPlan& plan) {
    plan.mirror.resize(plan.column.size());
    for (int i = 0; i < static_cast<int>(changed.size()); ++i)
        for (int k = plan.row_begin[i]; k < plan.row_begin[i + 1]; ++k) {
            const int j = plan.column[k];
            if (changed[i] || changed[j])
                plan.mirror[k] = find(plan, j, i);
            else
                plan.mirror[k] = from.mirror[from.row_begin[i] + k - plan.row_begin[i]] -
                                 from.row_begin[j] + plan.row_begin[j];
        }
}

}  // namespace

AssemblyPlan plan_assembly(const Body& body, Tangent tangent) {
    AssemblyPlan plan;
    lay_out_slots(body, tangent, plan);
    lay_out_rows(body, plan);
    return plan;
}

AssemblyPlan plan_after_split(const AssemblyPlan& plan, const Body& before, const Body& body) {
    const std::vector<std::uint8_t> changed = changed_nodes(before, body);
    AssemblyPlan after;
    after.groups = plan.groups;
    after.force_slots = plan.force_slots;
    after.block_slots = plan.block_slots;
    after.lambda_over_mu = plan.lambda_over_mu;
    make_room_as(plan, after);
    list_forces(body, after);
    RowPlan row(body, after);
    for (int i = 0; i < body.node_count(); ++i) {
        if (changed[i]) {
            row.find(i);
            append_row(i, row, after);
            continue;
        }
        const int first = i;
        while (i + 1 < body.node_count() && !changed[i + 1]) ++i;
        take_rows(plan, first, i + 1, after);
    }
    take_mirror(plan, changed, after);
    return after;
}

std::vector<int> connected_pieces(const AssemblyPlan& plan) {
    const auto empty = [](const GatherLists& lists, int k) {
        return lists.begin[k] == lists.begin[k + 1];
    };
    const auto of_an_element = [&](int k) {
        const int upper = std::min(k, plan.mirror[k]);
        return !empty(plan.factors, upper) || !empty(plan.blocks, upper) ||
               !empty(plan.transposed, upper);
    };
    std::vector<int> piece(plan.diagonal.size(), -1), reached;
    int count = 0;
    for (std::size_t first = 0; first < piece.size(); ++first) {
        if (piece[first] >= 0) continue;
        piece[first] = count;
        reached.assign(1, static_cast<int>(first));
        while (!reached.empty()) {
            const int i = reached.back();
            reached.pop_back();
            for (int k = plan.row_begin[i]; k < plan.row_begin[i + 1]; ++k) {
                const int j = plan.column[k];
                if (piece[j] >= 0 || !of_an_element(k)) continue;
                piece[j] = count;
                reached.push_back(j);
            }
        }
        ++count;
    }
    return piece;
}

}  // namespace hepatica
