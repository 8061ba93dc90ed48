// SPDX-License-Identifier: GPL-3.0-or-later
// The grabs of a body on a machine.
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

    // As validate_grabs demands. While they hold the same nodes, only the few grabs are copied.
    void set(std::span<const Grab> grabs, const AssemblyPlan& plan);
    // With another plan: what is known of the nodes they hold is found anew.
    void follow_tear(std::span<const Grab> grabs, const AssemblyPlan& plan) {
        held_.clear();
        set(grabs, plan);
    }
    // Their forces at these positions.
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
