// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/step/device_skeleton.h"

#include <algorithm>

namespace hepatica::gpu {
namespace {

BlockMatrix pattern_of(const AssemblyPlan& plan) {
    return {plan.row_begin, plan.column, {}, plan.diagonal, {}};
}

std::vector<CutListsView::Term> rows_of(const CoarsePlan& plan) {
    std::vector<CutListsView::Term> terms;
    for (const CutTerm& term : plan.in_row) terms.push_back({term.block, term.cut});
    return terms;
}

std::vector<CutListsView::Update> updates_of(const CoarsePlan& plan) {
    std::vector<CutListsView::Update> updates;
    for (const auto& [left, right] : plan.update) updates.push_back({left, right});
    return updates;
}

AffineCoarseSpace space_of(const CoarseSkeleton& skeleton, std::span<const Vec3> rest_positions_mm,
                           const AssemblyPlan& plan) {
    return {skeleton, bind_vertices(skeleton, rest_positions_mm), pattern_of(plan)};
}

}  // namespace

template <class Real>
DeviceSkeleton<Real>::DeviceSkeleton(Machine& machine, const CoarseSkeleton& skeleton,
                                     std::span<const Vec3> rest_positions_mm,
                                     const AssemblyPlan& plan)
    : machine_(machine), by_node_(machine), modes_(machine, rest_positions_mm.size()) {
    const AffineCoarseSpace space = space_of(skeleton, rest_positions_mm, plan);
    plan_ = plan_coarse(skeleton, space.coarse_pattern());
    set_vertices(space, skeleton);
    set_pairs(space.coarse_pattern());
    by_level_ = {machine, plan_.by_level};
    column_begin_ = {machine, plan_.column_begin};
    row_ = {machine, plan_.row};
    row_begin_ = {machine, plan_.row_begin};
    in_row_ = {machine, rows_of(plan_)};
    update_begin_ = {machine, plan_.update_begin};
    update_ = {machine, updates_of(plan_)};
    for (const CutStages& tier : plan_.tiers) stage_begin_.emplace_back(machine, tier.begin);
    const auto entries = static_cast<std::size_t>(cut_entries) * plan_.row.size();
    for (auto* blocks : {&matrix_, &reduced_, &multiplier_}) *blocks = {machine, entries};
    factor_ = {machine, entries};
    inverse_ = {machine, static_cast<std::size_t>(cut_entries * plan_.cuts())};
    for (auto* vector : {&load_, &motion_})
        *vector = {machine, static_cast<std::size_t>(cut_rows * plan_.cuts())};
}

// What does not change with the shape: shares and radii, and the vertices of each slot.
template <class Real>
void DeviceSkeleton<Real>::set_vertices(const AffineCoarseSpace& space,
                                        const CoarseSkeleton& skeleton) {
    const SkeletonBinding& binding = space.binding();
    std::vector<VertexShares> shares;
    std::vector<std::vector<int>> of_slot(static_cast<std::size_t>(plan_.slots()));
    for (std::size_t v = 0; v < binding.nodes.size(); ++v) {
        VertexShares own{};
        for (int side = 0; side < 2; ++side) {
            own.node[side] = plan_.slot_of_node[binding.nodes[v][side]];
            own.share[side] = binding.weights[v][side];
            if (side == 0 || own.node[1] != own.node[0])
                of_slot[own.node[side]].push_back(static_cast<int>(v));
        }
        shares.push_back(own);
    }
    std::vector<double> radius(of_slot.size(), 1.0);
    for (int n = 0; n < skeleton.size(); ++n) radius[plan_.slot_of_node[n]] = skeleton.radii_mm[n];
    std::vector<int> begin{0}, vertex, node;
    for (std::size_t slot = 0; slot < of_slot.size(); ++slot) {
        vertex.insert(vertex.end(), of_slot[slot].begin(), of_slot[slot].end());
        node.resize(vertex.size(), static_cast<int>(slot));
        begin.push_back(static_cast<int>(vertex.size()));
    }
    by_node_.set(node, plan_.slots());
    shares_ = {machine_, shares};
    radius_ = {machine_, radius};
    centre_ = {machine_, radius.size()};
    vertices_begin_ = {machine_, begin};
    vertex_ = {machine_, vertex};
    node_ = {machine_, node};
}

// Every pair of nodes in the lower triangle of the factor, and both of a cut with each other.
template <class Real>
void DeviceSkeleton<Real>::set_pairs(const BlockMatrix& coarse) {
    constexpr int node_rows = 3 * coarse_vectors;
    std::vector<NodePair> pairs;
    for (std::size_t n = 0; n < plan_.slot_of_node.size(); ++n) {
        const int own = plan_.slot_of_node[n], first = coarse_vectors * static_cast<int>(n);
        for (int k = coarse.row_begin[first]; k < coarse.row_begin[first + 1];
             k += coarse_vectors) {
            const int other = plan_.slot_of_node[coarse.column[k] / coarse_vectors];
            if (own / 2 < other / 2) continue;
            pairs.push_back({own, other, plan_.find(own / 2, other / 2), node_rows * (own % 2),
                             node_rows * (other % 2)});
        }
    }
    pair_ = {machine_, pairs};
}

template <class Real>
CutListsView DeviceSkeleton<Real>::lists() const {
    return {by_level_.read(), column_begin_.read(), row_.read(),   row_begin_.read(),
            in_row_.read(),   update_begin_.read(), update_.read()};
}

template <class Real>
void DeviceSkeleton<Real>::prepare(const SystemView<Real>& system,
                                   View<const Vector3<double>> position) {
    by_node_.sum_segments(CentreOfNode{shares_.read(), vertex_.read(), node_.read(), position},
                          KeepCentre{centre_.view()});
    machine_.for_each(ShapeModes<Real>{shares_.read(), position, centre_.read(), radius_.read(),
                                       system.held, modes_.view()});
    machine_.launch(ProjectMatrix<Real>{system,
                                        modes_.read(),
                                        {vertices_begin_.read(), vertex_.read()},
                                        pair_.read(),
                                        matrix_.view()});
    for (int level = 0; level < plan_.levels(); ++level) {
        const int first = plan_.level_begin[level];
        machine_.launch(EliminateCuts<Real>{lists(), first, plan_.level_begin[level + 1] - first,
                                            matrix_.read(), reduced_.view(), multiplier_.view(),
                                            inverse_.view(), factor_.view()});
    }
}

template <class Real>
void DeviceSkeleton<Real>::solve() const {
    const std::size_t last = plan_.tiers.size() - 1;
    for (std::size_t tier = 0; tier < last; ++tier) solve(tier, CutSolve::forward);
    solve(last, CutSolve::both);
    for (std::size_t tier = last; tier-- > 0;) solve(tier, CutSolve::backward);
}

template <class Real>
void DeviceSkeleton<Real>::solve(std::size_t tier, CutSolve way) const {
    const CutStages& stages = plan_.tiers[tier];
    const int solved = stages.begin.back() - stages.begin.front();
    machine_.launch(SolveCuts<Real>{lists(), solved, stages.stages, stage_begin_[tier].read(), way,
                                    inverse_.read(), factor_.read(), load_.view(), motion_.view()});
}

template class DeviceSkeleton<float>;
template class DeviceSkeleton<double>;

}  // namespace hepatica::gpu
