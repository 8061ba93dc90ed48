// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/step/device_skeleton.h"

#include <algorithm>

#include "gpu/step/coarse_program.h"

namespace hepatica::gpu {
namespace {

BlockMatrix pattern_of(const AssemblyPlan& plan) {
    return {plan.row_begin, plan.column, {}, plan.diagonal, {}};
}

std::vector<std::vector<int>> vertices_of_nodes(const AffineCoarseSpace& space) {
    std::vector<std::vector<int>> vertices(static_cast<std::size_t>(space.node_count()));
    const auto& nodes = space.binding().nodes;
    for (std::size_t v = 0; v < nodes.size(); ++v)
        for (int side = 0; side < (nodes[v][0] == nodes[v][1] ? 1 : 2); ++side)
            vertices[nodes[v][side]].push_back(static_cast<int>(v));
    return vertices;
}

std::vector<int> flat(const std::vector<std::vector<int>>& lists) {
    std::vector<int> all;
    for (const auto& list : lists) all.insert(all.end(), list.begin(), list.end());
    return all;
}

// The number of its list, for every entry.
std::vector<int> owners(const std::vector<std::vector<int>>& lists) {
    std::vector<int> all;
    for (std::size_t k = 0; k < lists.size(); ++k)
        all.insert(all.end(), lists[k].size(), static_cast<int>(k));
    return all;
}

}  // namespace

template <class Real>
DeviceSkeleton<Real>::DeviceSkeleton(Machine& machine, const CoarseSkeleton& skeleton,
                                     std::span<const Vec3> rest_positions_mm,
                                     const AssemblyPlan& plan)
    : machine_(machine),
      space_(skeleton, bind_vertices(skeleton, rest_positions_mm), pattern_of(plan)),
      order_(bisecting_order(skeleton)),
      coarse_(space_.coarse_pattern()),
      vertex_of_(flat(vertices_of_nodes(space_))),
      node_of_(owners(vertices_of_nodes(space_))),
      restriction_(machine),
      modes_(machine, rest_positions_mm.size()),
      vertex_(machine, vertex_of_),
      node_(machine, node_of_),
      column_(machine, coarse_.column),
      projected_(machine, coarse_.column.size()) {
    restriction_.set(node_of_, space_.node_count());
    std::vector<int> begin{0}, row;
    for (const auto& vertices : vertices_of_nodes(space_))
        begin.push_back(begin.back() + static_cast<int>(vertices.size()));
    for (int i = 0; i < coarse_.rows(); ++i)
        row.insert(row.end(), coarse_.row_begin[i + 1] - coarse_.row_begin[i], i);
    vertices_begin_ = {machine, begin};
    row_ = {machine, row};
}

template <class Real>
std::vector<VertexModes<Real>> DeviceSkeleton<Real>::rounded_modes() const {
    std::vector<VertexModes<Real>> modes(space_.modes().size());
    for (std::size_t v = 0; v < modes.size(); ++v)
        for (int side = 0; side < 2; ++side) {
            modes[v].node[side] = space_.binding().nodes[v][side];
            for (int m = 0; m < coarse_vectors; ++m)
                modes[v].weight[side][m] = static_cast<Real>(space_.modes()[v][side][m]);
        }
    return modes;
}

template <class Real>
void DeviceSkeleton<Real>::prepare(const SystemView<Real>& system,
                                   std::span<const Vec3> positions_mm,
                                   std::span<const std::uint8_t> held) {
    space_.set_shape(positions_mm, std::vector<char>(held.begin(), held.end()));
    modes_.upload(rounded_modes());
    machine_.for_each(ProjectMatrix<Real>{system,
                                          modes_.read(),
                                          {vertices_begin_.read(), vertex_.read()},
                                          row_.read(),
                                          column_.read(),
                                          projected_.view()});
    std::vector<Matrix3<double>> projected(coarse_.block.size());
    projected_.download(projected);
    for (std::size_t k = 0; k < projected.size(); ++k)
        for (int r = 0; r < 3; ++r)
            for (int c = 0; c < 3; ++c) coarse_.block[k](r, c) = projected[k](r, c);
    const CoarseProgram program = program_of(coarse_, order_);
    stage_begin_ = {machine_, program.stage_begin};
    target_ = {machine_, program.target};
    begin_ = {machine_, program.begin};
    source_ = {machine_, program.source};
    factor_ = {machine_, std::vector<Real>(program.factor.begin(), program.factor.end())};
    if (value_.size() == 0) value_ = {machine_, static_cast<std::size_t>(program.values)};
    solution_ = program.solution;
}

template class DeviceSkeleton<float>;
template class DeviceSkeleton<double>;

}  // namespace hepatica::gpu
