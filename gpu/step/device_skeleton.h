// SPDX-License-Identifier: GPL-3.0-or-later
// The second level of the preconditioner on a machine: z += P (P^T A P)^-1 P^T r, with the vessel
// tree's centreline as the coarse grid. It is prepared anew for every matrix, so that no step
// depends on the one before: P^T A P is computed there, its small factor on the host.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/deform/solvers/affine_coarse_space.h"
#include "core/deform/step/assembly_plan.h"
#include "gpu/kernels/coarse_kernels.h"
#include "gpu/step/partition.h"

namespace hepatica::gpu {

template <class Real>
class DeviceSkeleton {
  public:
    // The skeleton has one node or more; one rest position a node of the body.
    DeviceSkeleton(Machine& machine, const CoarseSkeleton& skeleton,
                   std::span<const Vec3> rest_positions_mm, const AssemblyPlan& plan);

    // At this shape of the body; held nodes do not move with the skeleton.
    void prepare(const SystemView<Real>& system, std::span<const Vec3> positions_mm,
                 std::span<const std::uint8_t> held);

    // Adds the correction to z, and hands r . z and r . r to `then`.
    template <class Then>
    void correct(const Partition& nodes, View<const Vector3<Real>> r, View<Vector3<Real>> z,
                 const Then& then) const {
        restriction_.sum(RestrictResidual<Real>{modes_.read(), vertex_.read(), node_.read(), r},
                         KeepSums<3 * coarse_vectors>{value_.view()});
        machine_.launch(RunStages<Real>{stage_begin_.read(), target_.read(), begin_.read(),
                                        source_.read(), factor_.read(), value_.view()});
        const int n = static_cast<int>(value_.size()) - solution_;
        nodes.sum(AddMotion<Real>{modes_.read(), {value_.read().data + solution_, n}, r, z}, then);
    }

  private:
    std::vector<VertexModes<Real>> rounded_modes() const;

    Machine& machine_;
    AffineCoarseSpace space_;
    std::vector<int> order_;
    BlockMatrix coarse_;
    std::vector<int> vertex_of_, node_of_;  // vertices by node
    Partition restriction_;
    Array<VertexModes<Real>> modes_;
    Array<int> vertices_begin_, vertex_, node_, row_, column_;
    Array<Matrix3<double>> projected_;
    Array<int> stage_begin_, target_, begin_, source_;
    Array<Real> factor_;
    Array<double> value_;
    int solution_ = 0;
};

extern template class DeviceSkeleton<float>;
extern template class DeviceSkeleton<double>;

}  // namespace hepatica::gpu
