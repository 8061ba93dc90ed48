// SPDX-License-Identifier: GPL-3.0-or-later
// The lateral stiffness of elements that are stretched so far that they have collapsed. With the
// principal stretches s0 >= s1 >= |s2| and z = s1 + s2 the energy of the corotated law is smooth
// except for
//   V c z,   c = lambda (s0 - 3) - 2 mu,
// where z >= 0 is the length of a vector with two components: the lateral widening of the element
// and its rotation about its long axis. Where c > 0, beyond a stretch of 3 + 2 mu / lambda, this
// term is a cone with its minimum at the tip z = 0, and the element collapses to it. The rotated
// stiffness does not contain the cone: its direction overshoots the tip, and the kink there
// shortens the step of the whole body to almost nothing. Therefore
//   d^T C d = V c / z |dz|^2,
// the smallest quadratic form that bounds the cone from above, is added to the matrix of a step,
// and for the rotation also V (mu + lambda) of the smooth part, which the rotated stiffness lacks
// too. Energies, forces and damping do not contain it.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/deform/body/body.h"
#include "core/deform/solvers/block_matrix.h"
#include "core/deform/step/assembly_plan.h"
#include "core/deform/step/element_slots.h"
#include "core/deform/step/live_set.h"

namespace hepatica {

// For the elements whose stiffness is written in factors. Keeps references. Not thread-safe.
class CollapseStiffness {
  public:
    CollapseStiffness(const Body& body, const AssemblyPlan& plan, const LiveSet& live)
        : body_(body), plan_(plan), live_(live) {}

    // Finds the collapsed live elements at the positions of the last evaluation of `slots`. Costs
    // one comparison per element, and a singular value decomposition for candidates.
    void find(const ElementSlots& slots, std::span<const Vec3> positions_mm);
    bool any() const { return !collapsed_.empty(); }
    // Forgets what find() found: for a matrix without it.
    void leave_out() { collapsed_.clear(); }
    // To be called after the body's nodes were split.
    void forget() {
        leave_out();
        least_nj_.clear();
    }

    // Adds factor * C, without the rows and columns of held nodes.
    void add_to(BlockMatrix& matrix, double factor) const;
    // Adds factor * C d. d must be 0 at held nodes; the rows of these nodes are meaningless.
    void add_product(std::span<const Vec3> d, double factor, std::span<Vec3> product) const;

  private:
    // The two components of dz, each times the root of its stiffness: the sums of widens[a] . d_a
    // and of turns[a] . d_a.
    struct Collapsed {
        const int* nodes;
        std::array<Vec3, 4> widens, turns;
    };
    void find_least_energies();
    void add_if_collapsed(const ElementGroup& group, int element,
                          std::span<const Vec3> positions_mm);

    const Body& body_;
    const AssemblyPlan& plan_;
    const LiveSet& live_;
    std::vector<Collapsed> collapsed_;
    // For each element of each group in factors: the least energy that it stores once collapsed.
    std::vector<std::vector<double>> least_nj_;
};

}  // namespace hepatica
