// SPDX-License-Identifier: GPL-3.0-or-later
// What every element of a body writes: its forces and its stiffness, into slots of its own, as the
// paper has it. Tetrahedra are evaluated four at a time, in the lanes of a register, where their
// law is written for that; a linear corotated one writes its stiffness in factors, which is a
// quarter of the memory traffic (see evaluate_turned_gradients).
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/base/vector.h"
#include "core/deform/body/body.h"
#include "core/deform/elements/lanes.h"

namespace hepatica {

// Keeps a reference to the body. Not thread-safe; loops inside run in parallel and give the same
// bits for any number of threads.
class ElementSlots {
  public:
    // `tangent` is the stiffness that is written, not Tangent::none.
    ElementSlots(const Body& body, small::Tangent tangent);

    // Evaluates all elements at the positions; returns the elastic energy [nJ].
    double evaluate(std::span<const Vec3> positions_mm);
    // The elastic energy alone; leaves the slots as they are.
    double energy(std::span<const Vec3> positions_mm) const;
    // d^T K d over the slots and differences of d, independent of any matrix.
    double quadratic_form(std::span<const Vec3> d) const;

    // Three entries, the fourth 0.
    using Wide = small::Lanes<double, 4>;

    // Elastic force [uN] on node a of element e is force()[force_slot(g, e) + a].
    int force_slot(std::size_t g, int e) const;
    const Wide* force() const { return force_.data(); }

    // Whether the elements of group g write their stiffness in factors: turned gradients, which
    // stand where the forces do. Otherwise as blocks [uN/mm], row-major.
    bool in_factors(std::size_t g) const { return groups_[g].in_factors; }
    const Wide* turned_gradient() const { return turned_gradient_.data(); }
    // lambda / mu of all groups in factors.
    double lambda_over_mu() const { return lambda_over_mu_; }
    int block_slot(std::size_t g, int e, int pair) const;
    const small::Matrix3<double>& block(int slot) const { return block_[slot]; }

  private:
    struct Group {
        bool in_lanes = false;
        bool in_factors = false;
        std::size_t first_force = 0;
        std::size_t first_block = 0;
        std::vector<small::TetrahedronRest<Wide>> tetrahedra;  // four elements each
    };
    // Up to four elements; lanes without one repeat the last.
    struct Pack {
        std::size_t group;
        int first;  // element
        int count;
    };

    bool one_ratio(const ElementGroup& group);
    const int* nodes(const Pack& pack, int lane) const;
    void load(const Pack& pack, std::span<const Vec3> values, small::Vector3<Wide>* x) const;
    void store(const Pack& pack, const small::Vector3<Wide>* values, std::vector<Wide>& slots);
    template <class Visit>
    double sum_over_packs(const Visit& visit) const;
    double evaluate_factors(const Pack& pack, std::span<const Vec3> positions_mm);
    double evaluate_lanes(const Pack& pack, std::span<const Vec3> positions_mm);
    template <small::Tangent tangent>
    double evaluate_singly(const Pack& pack, std::span<const Vec3> positions_mm);
    double factored_form(const Pack& pack, std::span<const Vec3> d) const;
    double block_form(const ElementGroup& group, int slot, int e, std::span<const Vec3> d) const;

    const Body& body_;
    small::Tangent tangent_;
    double lambda_over_mu_ = 0.0;
    std::vector<Group> groups_;
    std::vector<Wide> force_;
    std::vector<Wide> turned_gradient_;
    std::vector<small::Matrix3<double>> block_;
};

}  // namespace hepatica
