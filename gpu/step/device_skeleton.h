// SPDX-License-Identifier: GPL-3.0-or-later
// The second level of the preconditioner on a machine: z += P (P^T A P)^-1 P^T r, with the vessel
// tree's centreline as coarse grid. It is prepared anew for every matrix, so that no step depends
// on an earlier one: P, P^T A P and its factor are computed on the machine.
#pragma once

#include <span>
#include <vector>

#include "core/deform/solvers/affine_coarse_space.h"
#include "core/deform/step/assembly_plan.h"
#include "gpu/kernels/coarse_kernels.h"
#include "gpu/step/coarse_plan.h"
#include "gpu/step/partition.h"
#include "gpu/step/whole_sum.h"

namespace hepatica::gpu {

template <class Real>
class DeviceSkeleton {
  public:
    // Requires at least one node in the skeleton, and one rest position per node of the body.
    DeviceSkeleton(Machine& machine, const CoarseSkeleton& skeleton,
                   std::span<const Vec3> rest_positions_mm, const AssemblyPlan& plan);

    // Prepares for `system` at these positions; nodes that it holds do not move with the skeleton.
    void prepare(const SystemView<Real>& system, View<const Vector3<double>> position);

    // Adds the correction to z, and passes r . z and r . r to `then`.
    template <class Then>
    void correct(const WholeSum& nodes, View<const Vector3<Real>> r, View<Vector3<Real>> z,
                 const Then& then) const {
        by_node_.sum(RestrictResidual<Real>{modes_.read(), vertex_.read(), node_.read(), r},
                     KeepSums<3 * coarse_vectors>{load_.view()});
        solve();
        nodes.sum(AddMotion<Real>{modes_.read(), motions_.read(), r, z}, then);
    }

  private:
    void set_vertices(const AffineCoarseSpace& space, const CoarseSkeleton& skeleton);
    void set_pairs(const AffineCoarseSpace& space, const AssemblyPlan& plan);
    void set_inverse();
    CutListsView lists() const;
    InverseListsView inverse_lists() const;
    void factor();
    void solve() const;

    Machine& machine_;
    CoarsePlan plan_;
    Partition by_node_;
    Array<VertexShares> shares_;
    Array<double> radius_;
    Array<Vector3<double>> centre_;
    Array<VertexModes<Real>> modes_;
    Array<int> vertex_, node_;  // vertices by node
    Array<NodePair> pair_;
    Array<CoarseElement> element_;
    Array<int> element_vertex_, parts_begin_, parts_;
    Array<double> part_;
    Array<int> by_level_, column_begin_, update_begin_;
    Array<CutListsView::Update> update_;
    Array<int> inverse_by_level_, column_, product_begin_, chunk_begin_, first_chunk_, above_begin_;
    Array<InverseListsView::Product> product_;
    Array<InverseListsView::Above> above_;
    Array<double> matrix_, reduced_, multiplier_, pivot_;  // the last: D^-1
    Array<Real> factor_, inverse_;                         // N, N^-1
    Array<double> load_, partial_, divided_;               // of a solve
    Array<NodeMotion<Real>> motions_;
};

extern template class DeviceSkeleton<float>;
extern template class DeviceSkeleton<double>;

}  // namespace hepatica::gpu
