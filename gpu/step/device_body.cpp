// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/step/device_body.h"

#include <algorithm>

namespace hepatica::gpu {
namespace {

using Kind = ElementGroup::Kind;

template <class Real>
Vector3<Real> rounded(const Vector3<double>& v) {
    return {{static_cast<Real>(v[0]), static_cast<Real>(v[1]), static_cast<Real>(v[2])}};
}

template <class Real>
small::TetrahedronRest<Real> rounded(const small::TetrahedronRest<double>& rest) {
    small::TetrahedronRest<Real> r;
    for (int a = 0; a < 3; ++a) r.gradient[a] = rounded<Real>(rest.gradient[a]);
    r.volume = static_cast<Real>(rest.volume);
    r.lambda = static_cast<Real>(rest.lambda);
    r.mu = static_cast<Real>(rest.mu);
    return r;
}

template <class Real>
small::SpringRest<Real> rounded(const small::SpringRest<double>& rest) {
    small::SpringRest<Real> r;
    for (int e = 0; e < 6; ++e) {
        r.length[e] = static_cast<Real>(rest.length[e]);
        r.stiffness[e] = static_cast<Real>(rest.stiffness[e]);
    }
    r.volume = static_cast<Real>(rest.volume);
    r.bulk = static_cast<Real>(rest.bulk);
    return r;
}

template <class Real, template <class> class Rest>
std::vector<Rest<Real>> all_rounded(const std::vector<Rest<double>>& rest) {
    std::vector<Rest<Real>> all;
    all.reserve(rest.size());
    for (const auto& one : rest) all.push_back(rounded<Real>(one));
    return all;
}

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
      force_lists_{{machine, plan.forces.begin}, {machine, plan.forces.place}},
      force_(machine, body.rest_positions_mm.size()),
      energy_(machine, body.rest_positions_mm.size()) {
    if (!plan.factors.place.empty())
        turned_ = Array<Vector3<Real>>(machine, static_cast<std::size_t>(plan.force_slots));
    for (std::size_t g = 0; g < body.groups.size(); ++g)
        upload_group(body.groups[g], plan.groups[g]);
    upload_pattern(plan);
}

template <class Real>
void DeviceBody<Real>::upload_group(const ElementGroup& group, const GroupSlots& slots) {
    groups_.push_back({group.kind,
                       slots.in_factors,
                       static_cast<int>(slots.first_force),
                       static_cast<int>(slots.first_block),
                       slots.in_factors ? 0 : group.size() * group.pairs(),
                       {machine_, group.connectivity},
                       {machine_, all_rounded<Real>(group.tetrahedra)},
                       {machine_, all_rounded<Real>(group.springs)}});
}

// The plan's pattern without its diagonal, and the plan's lists of upper blocks alone.
template <class Real>
void DeviceBody<Real>::upload_pattern(const AssemblyPlan& plan) {
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
    const auto of_upper = [&](const GatherLists& lists) -> Lists {
        std::vector<int> begin;
        for (const int k : upper) begin.push_back(lists.begin[k]);
        begin.push_back(lists.begin.back());
        return {{machine_, begin}, {machine_, lists.place}};
    };
    factors_ = of_upper(plan.factors);
    blocks_ = of_upper(plan.blocks);
    transposed_ = of_upper(plan.transposed);
    row_begin_ = {machine_, row_begin};
    column_ = {machine_, column};
    place_ = {machine_, place};
    mirror_ = {machine_, mirror};
    block_ = {machine_, column.size()};
}

template <class Real>
void DeviceBody<Real>::evaluate_group(const Group& group, View<const Vector3<double>> position,
                                      bool with_stiffness) {
    const GroupViews<Real> views{group.connectivity.read(), position, slot_.view(),
                                 group.first_slot};
    View<Matrix3<Real>> block;
    if (with_stiffness) block = {block_slot_.view().data + group.first_block, group.blocks};
    const auto rest = group.tetrahedra.read();
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
        GatherForces<Real>{force_lists_.view(), slot_.read(), force_.view(), energy_.view()});
}

template <class Real>
void DeviceBody<Real>::assemble() {
    machine_.for_each(GatherStiffness<Real>{place_.read(), mirror_.read(), factors_.view(),
                                            blocks_.view(), transposed_.view(), turned_.read(),
                                            block_slot_.read(), lambda_over_mu_, block_.view()});
}

template class DeviceBody<float>;
template class DeviceBody<double>;

}  // namespace hepatica::gpu
