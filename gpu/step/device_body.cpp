// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/step/device_body.h"

#include <algorithm>
#include <utility>

#include "gpu/step/row_chunks.h"

namespace hepatica::gpu {
namespace {

using Kind = ElementGroup::Kind;

}  // namespace

bool has_kernels(const Body& body) {
    return std::ranges::all_of(body.groups, [&](const ElementGroup& group) {
        return group.kind == Kind::linear_tetrahedron || group.kind == Kind::spring ||
               (group.kind == Kind::quadratic_tetrahedron && body.model == ElementModel::corotated);
    });
}

template <class Real>
DeviceBody<Real>::DeviceBody(Machine& machine, const Body& body, const AssemblyPlan& plan)
    : machine_(machine),
      model_(body.model),
      lambda_over_mu_(static_cast<Real>(plan.lambda_over_mu)),
      slot_(machine, static_cast<std::size_t>(plan.force_slots)),
      block_slot_(machine, static_cast<std::size_t>(plan.block_slots)),
      force_lists_(machine),
      factors_(machine),
      blocks_(machine),
      transposed_(machine),
      force_(machine),
      energy_(machine),
      row_begin_(machine),
      column_(machine),
      place_(machine),
      mirror_(machine),
      chunk_begin_(machine),
      chunk_entry_(machine),
      row_in_chunk_(machine),
      block_(machine) {
    if (!plan.factors.place.empty())
        turned_ = Array<Aligned3<Real>>(machine, static_cast<std::size_t>(plan.force_slots));
    for (std::size_t g = 0; g < body.groups.size(); ++g) add_group(body.groups[g], plan.groups[g]);
    follow(body, plan);
}

template <class Real>
void DeviceBody<Real>::follow(const Body& body, const AssemblyPlan& plan) {
    force_.resize(body.rest_positions_mm.size());
    energy_.resize(body.rest_positions_mm.size());
    for (std::size_t g = 0; g < groups_.size(); ++g)
        groups_[g].connectivity.set(body.groups[g].connectivity);
    force_lists_.begin.set(plan.forces.begin);
    force_lists_.place.set(plan.forces.place);
    set_pattern(plan);
}

template <class Real>
void DeviceBody<Real>::add_group(const ElementGroup& group, const GroupSlots& slots) {
    groups_.push_back({group.kind,
                       slots.in_factors,
                       static_cast<int>(slots.first_force),
                       static_cast<int>(slots.first_block),
                       slots.in_factors ? 0 : group.size() * group.pairs(),
                       GrowingArray<int>(machine_),
                       {machine_, in_planes<double>(group.tetrahedra)},
                       {machine_, group.springs}});
}

// Uploads the plan's pattern without its diagonal, and the plan's lists for upper blocks alone.
template <class Real>
void DeviceBody<Real>::set_pattern(const AssemblyPlan& plan) {
    const auto beside = [&](int row, int k) { return k - row - (k > plan.diagonal[row] ? 1 : 0); };
    const int rows = static_cast<int>(plan.diagonal.size());
    std::vector<int> row_begin{0}, column, place, mirror, upper;
    for (int i = 0; i < rows; ++i) {
        for (int k = plan.row_begin[i]; k < plan.row_begin[i + 1]; ++k) {
            if (k == plan.diagonal[i]) continue;
            column.push_back(plan.column[k]);
            if (k < plan.diagonal[i]) continue;
            upper.push_back(k);
            place.push_back(beside(i, k));
            mirror.push_back(beside(plan.column[k], plan.mirror[k]));
        }
        row_begin.push_back(static_cast<int>(column.size()));
    }
    const auto set_upper = [&](const GatherLists& lists, Lists& to) {
        std::vector<int> begin;
        for (const int k : upper) begin.push_back(lists.begin[k]);
        begin.push_back(lists.begin.back());
        to.begin.set(std::move(begin));
        to.place.set(lists.place);
    };
    set_upper(plan.factors, factors_);
    set_upper(plan.blocks, blocks_);
    set_upper(plan.transposed, transposed_);
    block_.resize(9 * column.size());
    RowChunks chunks = chunks_of(row_begin);
    chunk_begin_.set(std::move(chunks.begin));
    chunk_entry_.set(std::move(chunks.entry));
    row_in_chunk_.set(std::move(chunks.row_of));
    row_begin_.set(std::move(row_begin));
    column_.set(std::move(column));
    place_.set(std::move(place));
    mirror_.set(std::move(mirror));
}

template <class Real>
void DeviceBody<Real>::evaluate_group(const Group& group, View<const Vector3<double>> position,
                                      bool with_stiffness) {
    const GroupViews views{group.connectivity.read(), position, slot_.view(), group.first_slot};
    View<Matrix3<Real>> block;
    if (with_stiffness) block = {block_slot_.view().data + group.first_block, group.blocks};
    const TetrahedronRests rest(group.tetrahedra.read());
    if (group.in_factors)
        machine_.for_each(EvaluateTurned<Real>{views, rest, turned_.view()});
    else if (group.kind == Kind::spring)
        machine_.for_each(EvaluateSprings<Real>{views, group.springs.read(), block});
    else if (group.kind == Kind::quadratic_tetrahedron)
        machine_.for_each(EvaluateCorotated10<Real>{views, rest, block});
    else if (model_ == ElementModel::neohookean)
        machine_.for_each(EvaluateNeoHookean<Real>{views, rest, block});
    else
        machine_.for_each(EvaluateCorotated<Real>{views, rest, block});
}

template <class Real>
void DeviceBody<Real>::evaluate(View<const Vector3<double>> position, bool with_stiffness) {
    for (const Group& group : groups_) evaluate_group(group, position, with_stiffness);
    machine_.for_each(
        GatherForces{force_lists_.view(), slot_.read(), force_.view(), energy_.view()});
}

template <class Real>
void DeviceBody<Real>::assemble() {
    machine_.for_each(GatherStiffness<Real>{place_.read(), mirror_.read(), factors_.view(),
                                            blocks_.view(), transposed_.view(), turned_.read(),
                                            block_slot_.read(), lambda_over_mu_,
                                            Planes<Matrix3<Real>, Real>(block_.view())});
}

template class DeviceBody<float>;
template class DeviceBody<double>;

}  // namespace hepatica::gpu
