// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/step/device_skeleton.h"

#include "gpu/step/coarse_elements.h"

namespace hepatica::gpu {
namespace {

BlockMatrix pattern_of(const AssemblyPlan& plan) {
    return {plan.row_begin, plan.column, {}, plan.diagonal, {}};
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
    set_pairs(space, plan);
    by_level_ = {machine, plan_.by_level};
    column_begin_ = {machine, plan_.column_begin};
    update_begin_ = {machine, plan_.update_begin};
    update_ = {machine, plan_.update};
    set_inverse();
    const auto entries = static_cast<std::size_t>(cut_entries) * plan_.row.size();
    for (auto* blocks : {&matrix_, &reduced_, &multiplier_}) *blocks = {machine, entries};
    factor_ = {machine, entries};
    pivot_ = {machine, static_cast<std::size_t>(cut_entries * plan_.cuts())};
    for (auto* vector : {&load_, &divided_})
        *vector = {machine, static_cast<std::size_t>(cut_rows * plan_.cuts())};
    motions_ = {machine, static_cast<std::size_t>(plan_.slots())};
}

// Uploads what does not depend on the shape: shares and radii, and the vertices of each slot.
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
    std::vector<int> vertex, node;
    for (std::size_t slot = 0; slot < of_slot.size(); ++slot) {
        vertex.insert(vertex.end(), of_slot[slot].begin(), of_slot[slot].end());
        node.resize(vertex.size(), static_cast<int>(slot));
    }
    by_node_.set(node, plan_.slots());
    shares_ = {machine_, shares};
    radius_ = {machine_, radius};
    centre_ = {machine_, radius.size()};
    vertex_ = {machine_, vertex};
    node_ = {machine_, node};
}

// Every pair of nodes in the lower triangle of the factor, and all four pairs within a cut.
template <class Real>
void DeviceSkeleton<Real>::set_pairs(const AffineCoarseSpace& space, const AssemblyPlan& plan) {
    const BlockMatrix coarse = space.coarse_pattern();
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
    std::vector<std::array<int, 2>> nodes = space.binding().nodes;
    for (auto& both : nodes)
        for (int& node : both) node = plan_.slot_of_node[node];
    const CoarseElements elements = plan_coarse_elements(nodes, plan, pairs);
    pair_ = {machine_, pairs};
    element_ = {machine_, elements.element};
    element_vertex_ = {machine_, elements.vertex};
    parts_begin_ = {machine_, elements.part_begin};
    parts_ = {machine_, elements.part};
    part_ = {machine_, elements.element.size() * 2 * CoarseElement::most_others *
                           CoarseElement::part_numbers};
}

template <class Real>
void DeviceSkeleton<Real>::set_inverse() {
    const InversePlan& plan = plan_.inverse;
    inverse_by_level_ = {machine_, plan.by_level};
    column_ = {machine_, plan.column};
    product_begin_ = {machine_, plan.product_begin};
    product_ = {machine_, plan.product};
    chunk_begin_ = {machine_, plan.chunk_begin};
    first_chunk_ = {machine_, plan.first_chunk};
    above_begin_ = {machine_, plan.above_begin};
    above_ = {machine_, plan.above};
    inverse_ = {machine_, static_cast<std::size_t>(cut_entries) * plan.column.size()};
    partial_ = {machine_, static_cast<std::size_t>(cut_rows) * (plan.chunk_begin.size() - 1)};
}

template <class Real>
CutListsView DeviceSkeleton<Real>::lists() const {
    return {by_level_.read(), column_begin_.read(), update_begin_.read(), update_.read()};
}

template <class Real>
InverseListsView DeviceSkeleton<Real>::inverse_lists() const {
    return {inverse_by_level_.read(), column_.read(),      product_begin_.read(), product_.read(),
            chunk_begin_.read(),      first_chunk_.read(), above_begin_.read(),   above_.read()};
}

template <class Real>
void DeviceSkeleton<Real>::prepare(const SystemView<Real>& system,
                                   View<const Vector3<double>> position) {
    by_node_.sum(CentreOfNode{shares_.read(), vertex_.read(), node_.read(), position},
                 KeepCentre{centre_.view()});
    machine_.for_each(ShapeModes<Real>{shares_.read(), position, centre_.read(), radius_.read(),
                                       system.held, modes_.view()});
    machine_.launch(ProjectElements<Real>{system, modes_.read(), element_.read(),
                                          element_vertex_.read(), part_.view()});
    machine_.launch(GatherProjected{pair_.read(), parts_begin_.read(), parts_.read(), part_.read(),
                                    matrix_.view()});
    factor();
}

template <class Real>
void DeviceSkeleton<Real>::factor() {
    for (int level = 0; level < plan_.levels(); ++level) {
        const int first = plan_.level_begin[level];
        machine_.launch(EliminateCuts<Real>{lists(), first, plan_.level_begin[level + 1] - first,
                                            matrix_.read(), reduced_.view(), multiplier_.view(),
                                            pivot_.view(), factor_.view()});
    }
    const std::vector<int>& begin = plan_.inverse.level_begin;
    for (std::size_t level = 0; level + 1 < begin.size(); ++level)
        machine_.launch(InvertFactor<Real>{inverse_lists(), begin[level],
                                           begin[level + 1] - begin[level], factor_.read(),
                                           inverse_.view()});
}

template <class Real>
void DeviceSkeleton<Real>::solve() const {
    machine_.launch(
        SumBelow<Real>{{}, inverse_lists(), inverse_.read(), load_.read(), partial_.view()});
    machine_.launch(DivideByPivots<Real>{
        {}, inverse_lists(), pivot_.read(), load_.read(), partial_.read(), divided_.view()});
    machine_.launch(
        SumAbove<Real>{{}, inverse_lists(), inverse_.read(), divided_.read(), motions_.view()});
}

template class DeviceSkeleton<float>;
template class DeviceSkeleton<double>;

}  // namespace hepatica::gpu
