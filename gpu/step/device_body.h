// SPDX-License-Identifier: GPL-3.0-or-later
// A body on a machine: elements, gather lists and the stiffness matrix, laid out by the
// AssemblyPlan that the CPU uses. Evaluates forces and assembles K.
#pragma once

#include <vector>

#include "core/deform/body/body.h"
#include "core/deform/step/assembly_plan.h"
#include "gpu/kernels/assembly_kernels.h"
#include "gpu/kernels/system_kernels.h"
#include "gpu/step/growing_array.h"

namespace hepatica::gpu {

// Whether all elements of this body have kernels.
bool has_kernels(const Body& body);

// Copies what it needs of its arguments. Real: number type of the matrix, float, or double for
// tests. Not thread-safe.
template <class Real>
class DeviceBody {
  public:
    // Requires has_kernels(body); the plan must be that of Tangent::rotated.
    DeviceBody(Machine& machine, const Body& body, const AssemblyPlan& plan);
    // Takes over a torn body: the same elements with other corners, and possibly other nodes.
    void follow(const Body& body, const AssemblyPlan& plan);

    // Computes the elastic force and energy of every node; `with_stiffness` also prepares
    // assemble().
    void evaluate(View<const Vector3<double>> position, bool with_stiffness);
    // Assembles the off-diagonal blocks of K from the last evaluation with stiffness.
    void assemble();

    View<const Vector3<double>> elastic_force() const { return force_.read(); }
    View<const double> elastic_energy() const { return energy_.read(); }
    View<const int> row_begin() const { return row_begin_.read(); }
    View<const int> column() const { return column_.read(); }
    RowChunksView row_chunks() const {
        return {chunk_begin_.read(), chunk_entry_.read(), row_in_chunk_.read()};
    }
    MatrixPlanes<Real> block() const { return MatrixPlanes<Real>(block_.read()); }

  private:
    struct Lists {
        explicit Lists(Machine& machine) : begin(machine), place(machine) {}
        GrowingArray<int> begin, place;
        ListsView view() const { return {begin.read(), place.read()}; }
    };
    struct Group {
        ElementGroup::Kind kind;
        bool in_factors;
        int first_slot, first_block, blocks;
        GrowingArray<int> connectivity;
        Array<double> tetrahedra;  // rest data, in planes
        Array<small::SpringRest<double>> springs;
    };

    void add_group(const ElementGroup& group, const GroupSlots& slots);
    void set_pattern(const AssemblyPlan& plan);
    void evaluate_group(const Group& group, View<const Vector3<double>> position,
                        bool with_stiffness);

    Machine& machine_;
    ElementModel model_;
    Real lambda_over_mu_;
    std::vector<Group> groups_;
    Array<ForceSlot> slot_;
    Array<Aligned3<Real>> turned_;
    Array<Matrix3<Real>> block_slot_;
    Lists force_lists_, factors_, blocks_, transposed_;
    GrowingArray<Vector3<double>> force_;
    GrowingArray<double> energy_;
    GrowingArray<int> row_begin_, column_, place_, mirror_, chunk_begin_, chunk_entry_;
    GrowingArray<unsigned char> row_in_chunk_;
    GrowingArray<Real> block_;  // in planes
};

extern template class DeviceBody<float>;
extern template class DeviceBody<double>;

}  // namespace hepatica::gpu
