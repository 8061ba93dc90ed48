// SPDX-License-Identifier: GPL-3.0-or-later
// A body on a machine: elements, gather lists and the matrix of their stiffness, laid out by the
// AssemblyPlan that the CPU uses. Evaluates and assembles.
#pragma once

#include <vector>

#include "core/deform/body/body.h"
#include "core/deform/step/assembly_plan.h"
#include "gpu/kernels/assembly_kernels.h"
#include "gpu/machine/array.h"

namespace hepatica::gpu {

// Whether elements and stiffness of this body have kernels.
bool has_kernels(const Body& body);

// Keeps what it needs. Real: float, or double for tests.
template <class Real>
class DeviceBody {
  public:
    // The body has_kernels(); the plan is that of Tangent::rotated.
    DeviceBody(Machine& machine, const Body& body, const AssemblyPlan& plan);

    // Elastic force and energy of every node there; `with_stiffness` for assemble().
    void evaluate(View<const Vector3<double>> position, bool with_stiffness);
    // K beside the diagonal, at the last evaluation with stiffness.
    void assemble();

    View<const Vector3<double>> elastic_force() const { return force_.read(); }
    View<const double> elastic_energy() const { return energy_.read(); }
    View<const int> row_begin() const { return row_begin_.read(); }
    View<const int> column() const { return column_.read(); }
    View<const Matrix3<Real>> block() const { return block_.read(); }
    std::size_t blocks() const { return block_.size(); }

  private:
    struct Lists {
        Array<int> begin, place;
        ListsView view() const { return {begin.read(), place.read()}; }
    };
    struct Group {
        ElementGroup::Kind kind;
        bool in_factors;
        int first_slot, first_block, blocks;
        Array<int> connectivity;
        Array<small::TetrahedronRest<Real>> tetrahedra;
        Array<small::SpringRest<Real>> springs;
    };

    void upload_pattern(const AssemblyPlan& plan);
    void upload_group(const ElementGroup& group, const GroupSlots& slots);
    void evaluate_group(const Group& group, View<const Vector3<double>> position,
                        bool with_stiffness);

    Machine& machine_;
    ElementModel model_;
    Real lambda_over_mu_;
    std::vector<Group> groups_;
    Array<ForceSlot<Real>> slot_;
    Array<Vector3<Real>> turned_;
    Array<Matrix3<Real>> block_slot_;
    Lists force_lists_, factors_, blocks_, transposed_;
    Array<Vector3<double>> force_;
    Array<double> energy_;
    Array<int> row_begin_, column_, place_, mirror_;
    Array<Matrix3<Real>> block_;
};

extern template class DeviceBody<float>;
extern template class DeviceBody<double>;

}  // namespace hepatica::gpu
