// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/step/assembly_plan.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/base/error.h"

namespace hepatica {
namespace {

using Kind = ElementGroup::Kind;
using small::Tangent;

// Elements of one ratio lambda / mu, whatever their modulus, and of that of the groups before.
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

void lay_out_pattern(const Body& body, AssemblyPlan& plan) {
    std::vector<std::array<int, 2>> entries;
    for (int i = 0; i < body.node_count(); ++i) entries.push_back({i, i});
    for (const ElementGroup& group : body.groups) {
        const int n = group.nodes_per_element;
        for (std::size_t first = 0; first < group.connectivity.size(); first += n)
            for (int a = 0; a < n; ++a)
                for (int b = 0; b < n; ++b)
                    if (a != b)
                        entries.push_back(
                            {group.connectivity[first + a], group.connectivity[first + b]});
    }
    for (const auto& [i, j] : body.parted_pairs) {
        entries.push_back({i, j});
        entries.push_back({j, i});
    }
    std::ranges::sort(entries);
    entries.erase(std::unique(entries.begin(), entries.end()), entries.end());
    plan.row_begin.assign(body.node_count() + 1, 0);
    plan.diagonal.resize(body.node_count());
    for (const auto& [i, j] : entries) {
        if (i == j) plan.diagonal[i] = static_cast<int>(plan.column.size());
        plan.column.push_back(j);
        ++plan.row_begin[i + 1];
    }
    for (int i = 0; i < body.node_count(); ++i) plan.row_begin[i + 1] += plan.row_begin[i];
    plan.mirror.resize(plan.column.size());
    for (int i = 0; i < body.node_count(); ++i)
        for (int k = plan.row_begin[i]; k < plan.row_begin[i + 1]; ++k)
            plan.mirror[k] = find(plan, plan.column[k], i);
}

// Sorts (entry, place) by entry; places of one entry keep their order.
GatherLists by_entry(std::size_t entries, const std::vector<std::array<int, 2>>& pairs) {
    GatherLists lists;
    lists.begin.assign(entries + 1, 0);
    for (const auto& [entry, place] : pairs) ++lists.begin[entry + 1];
    for (std::size_t k = 0; k < entries; ++k) lists.begin[k + 1] += lists.begin[k];
    lists.place.resize(pairs.size());
    std::vector<int> next = lists.begin;
    for (const auto& [entry, place] : pairs) lists.place[next[entry]++] = place;
    return lists;
}

void list_contributions(const Body& body, AssemblyPlan& plan) {
    std::vector<std::array<int, 2>> forces, factors, blocks, transposed;
    for (std::size_t g = 0; g < body.groups.size(); ++g) {
        const ElementGroup& group = body.groups[g];
        const int n = group.nodes_per_element;
        for (int e = 0; e < group.size(); ++e) {
            const int* nodes = group.connectivity.data() + static_cast<std::ptrdiff_t>(e) * n;
            const int first = plan.force_slot(g, e, n);
            for (int a = 0, pair = plan.block_slot(g, e, group.pairs()); a < n; ++a) {
                forces.push_back({nodes[a], first + a});
                for (int b = a + 1; b < n; ++b, ++pair) {
                    const bool turned = nodes[a] > nodes[b];
                    const int low = turned ? b : a, high = turned ? a : b;
                    const int k = find(plan, nodes[low], nodes[high]);
                    if (!plan.groups[g].in_factors) {
                        (turned ? transposed : blocks).push_back({k, pair});
                        continue;
                    }
                    factors.push_back({k, first + low});
                    factors.push_back({k, first + high});
                }
            }
        }
    }
    plan.forces = by_entry(static_cast<std::size_t>(body.node_count()), forces);
    plan.factors = by_entry(plan.column.size(), factors);
    plan.blocks = by_entry(plan.column.size(), blocks);
    plan.transposed = by_entry(plan.column.size(), transposed);
}

}  // namespace

AssemblyPlan plan_assembly(const Body& body, Tangent tangent) {
    AssemblyPlan plan;
    lay_out_slots(body, tangent, plan);
    lay_out_pattern(body, plan);
    list_contributions(body, plan);
    return plan;
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
