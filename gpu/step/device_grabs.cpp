// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/step/device_grabs.h"

#include <algorithm>

#include "core/base/small_matrix_eigen.h"

namespace hepatica::gpu {
namespace {

bool stored(const AssemblyPlan& plan, int i, int j) {
    const auto row = plan.column.begin();
    return std::binary_search(row + plan.row_begin[i], row + plan.row_begin[i + 1], j);
}

GrabSpring spring_of(const Grab& grab, const AssemblyPlan& plan) {
    GrabSpring spring{};
    spring.target = small::from_eigen(grab.target_mm);
    spring.stiffness = grab.stiffness_un_per_mm;
    spring.limit = grab.force_limit_un;
    for (int a = 0; a < 4; ++a) {
        spring.node[a] = grab.vertices[a];
        spring.weight[a] = grab.weights[a];
        for (int b = 0; b < 4; ++b)
            if (grab.vertices[a] >= 0 && grab.vertices[b] >= 0 &&
                stored(plan, grab.vertices[a], grab.vertices[b]))
                spring.stored |= 1u << (4 * a + b);
    }
    return spring;
}

}  // namespace

void DeviceGrabs::set(std::span<const Grab> grabs, const AssemblyPlan& plan) {
    std::vector<GrabSpring> springs;
    std::vector<std::array<int, 4>> held;
    for (const Grab& grab : grabs) {
        springs.push_back(spring_of(grab, plan));
        held.push_back(grab.vertices);
    }
    if (held != held_) {
        held_ = held;
        list_by_node(grabs, plan.diagonal.size());
        grab_ = {machine_, springs};
        pull_ = {machine_, springs.size()};
    } else {
        grab_.upload(springs);
    }
}

// Builds the linked lists from back to front, so that a node's grabs are visited in their own
// order.
void DeviceGrabs::list_by_node(std::span<const Grab> grabs, std::size_t nodes) {
    std::vector<int> first(grabs.empty() ? 0 : nodes, -1), next(4 * grabs.size(), -1);
    for (std::size_t entry = next.size(); entry-- > 0;) {
        const int node = grabs[entry / 4].vertices[entry % 4];
        if (node < 0) continue;
        next[entry] = first[node];
        first[node] = static_cast<int>(entry);
    }
    first_ = {machine_, first};
    next_ = {machine_, next};
}

}  // namespace hepatica::gpu
