// SPDX-License-Identifier: GPL-3.0-or-later
// The grabs of a body on a machine (grab_kernels.h).
#pragma once

#include <span>
#include <vector>

#include "core/deform/potentials/grab.h"
#include "core/deform/step/assembly_plan.h"
#include "gpu/kernels/grab_kernels.h"
#include "gpu/machine/array.h"

namespace hepatica::gpu {

class DeviceGrabs {
  public:
    explicit DeviceGrabs(Machine& machine) : machine_(machine) {}

    // Grabs must satisfy validate_grabs(). While they hold the same nodes, only the grabs
    // themselves are copied.
    void set(std::span<const Grab> grabs, const AssemblyPlan& plan);
    // Sets the grabs for another plan, and rebuilds the lists by node.
    void follow_tear(std::span<const Grab> grabs, const AssemblyPlan& plan) {
        held_.assign(1, {-1, -1, -1, -1});  // unlike any grabs, and unlike none
        set(grabs, plan);
    }
    // Computes their forces at these positions.
    void pull(View<const Vector3<double>> position) {
        machine_.for_each(PullGrabs{grab_.read(), position, pull_.view()});
    }
    GrabsView view() const { return {first_.read(), next_.read(), grab_.read(), pull_.read()}; }

  private:
    void list_by_node(std::span<const Grab> grabs, std::size_t nodes);

    Machine& machine_;
    std::vector<std::array<int, 4>> held_;
    Array<int> first_, next_;
    Array<GrabSpring> grab_;
    Array<GrabPull> pull_;
};

}  // namespace hepatica::gpu
