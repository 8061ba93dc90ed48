// SPDX-License-Identifier: GPL-3.0-or-later
// Evaluates every element of a body into slots of its own: its forces and its stiffness, as in the
// paper. Tetrahedra with the corotated law are evaluated four at a time in SIMD lanes. A linear one
// writes its stiffness in factors, which takes a quarter of the memory traffic (see
// evaluate_turned_gradients).
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "core/base/vector.h"
#include "core/deform/body/body.h"
#include "core/deform/elements/lanes.h"
#include "core/deform/step/assembly_plan.h"
#include "core/deform/step/live_set.h"

namespace hepatica {

// Keeps a reference to the body. Not thread-safe; loops inside run in parallel and give the same
// bits for any number of threads.
class ElementSlots {
  public:
    // `tangent` is the stiffness that is written; it must be that of the plan. Keeps a reference to
    // `live`; null: all elements are live.
    ElementSlots(const Body& body, small::Tangent tangent, std::shared_ptr<const AssemblyPlan> plan,
                 const LiveSet* live);

    // Evaluates the live elements at the positions; the others keep their energy. Returns the
    // elastic energy of all elements [nJ].
    double evaluate(std::span<const Vec3> positions_mm);
    // The same for energies and forces only; the stiffness in the slots is left unchanged.
    double evaluate_forces(std::span<const Vec3> positions_mm);
    // Evaluates every element, live or not. Needed after the state was changed from outside.
    double evaluate_all_forces(std::span<const Vec3> positions_mm);
    // Computes the elastic energy only and leaves the slots unchanged.
    double energy(std::span<const Vec3> positions_mm) const;
    // Adds the energy of every element at the last evaluation to the piece of its first node.
    void add_energy_by_piece(std::span<const int> piece_of_node, std::span<double> energy_nj) const;
    // Energy of each element of one group at the last evaluation [nJ].
    const std::vector<double>& energies(std::size_t group) const { return energy_[group]; }
    // The same for a group in factors: half the volume times the trace of the stress [nJ], from the
    // virial of the element's forces.
    const std::vector<double>& pulls(std::size_t group) const { return pull_[group]; }
    // First Piola-Kirchhoff stress [Pa] of the live linear tetrahedra at the last evaluation and
    // the energy [nJ] of all. Frozen elements keep their entries; an empty `stress_pa` is filled
    // for all. Other kinds of elements are not supported.
    void find_stress(std::vector<Mat3>& stress_pa, std::vector<double>& energy_nj) const;
    // d^T K d from the slots and differences of d, independent of any matrix; d must be 0 at nodes
    // that are not live.
    double quadratic_form(std::span<const Vec3> d) const;

    // Three entries; the fourth lane is 0.
    using Wide = small::Lanes<double, 4>;

    // Contents of the plan's slots: elastic forces [uN], turned gradients (see
    // evaluate_turned_gradients), and stiffness blocks [uN/mm].
    const Wide* force() const { return force_.data(); }
    const Wide* turned_gradient() const { return turned_gradient_.data(); }
    const small::Matrix3<double>& block(int slot) const { return block_[slot]; }

  private:
    // Up to four elements; unused lanes repeat the last one.
    struct Pack {
        std::size_t group;
        int first;  // number of its first element
        int count;
    };

    int force_slot(const Pack& pack) const;
    int block_slot(std::size_t group, int element) const;
    const int* nodes(const Pack& pack, int lane) const;
    void load(const Pack& pack, std::span<const Vec3> values, small::Vector3<Wide>* x) const;
    void store(const Pack& pack, const small::Vector3<Wide>* values, std::vector<Wide>& slots);
    // Calls visit(pack) for every pack, or for the live ones; returns the sum of the results.
    template <class Visit>
    double sum_over_packs(const LiveSet* live, const Visit& visit) const;
    double kept_energy() const;
    void find_forces(const LiveSet* live, std::span<const Vec3> positions_mm);
    void keep(const Pack& pack, const Wide& energy);
    void keep_pull(const Pack& pack, const small::Vector3<Wide>* x,
                   const small::Vector3<Wide>* force);
    void evaluate_factors(const Pack& pack, std::span<const Vec3> positions_mm);
    void evaluate_lanes(const Pack& pack, std::span<const Vec3> positions_mm);
    Wide forces_of_four(const Pack& pack, const small::Vector3<Wide>* x,
                        small::Vector3<Wide>* force) const;
    template <small::Tangent tangent>
    void evaluate_singly(const Pack& pack, std::span<const Vec3> positions_mm);
    bool four_at_a_time(const Pack& pack) const { return plan_->groups[pack.group].four_at_a_time; }
    double factored_form(const Pack& pack, std::span<const Vec3> d) const;
    double block_form(const ElementGroup& group, int slot, int e, std::span<const Vec3> d) const;

    const Body& body_;
    small::Tangent tangent_;
    std::shared_ptr<const AssemblyPlan> plan_;
    const LiveSet* live_;
    // Rest shapes of four elements each, for every group that is evaluated four at a time.
    std::vector<std::vector<small::TetrahedronRest<Wide>>> rest_of_four_;
    std::vector<std::vector<double>> energy_;  // of every element of every group
    std::vector<std::vector<double>> pull_;    // the same for groups in factors
    std::vector<Wide> force_;
    std::vector<Wide> turned_gradient_;
    std::vector<small::Matrix3<double>> block_;
};

}  // namespace hepatica
