// SPDX-License-Identifier: GPL-3.0-or-later
// The resistance of elements that are drawn out so far that they have collapsed across. With the
// principal stretches s0 >= s1 >= |s2| and z = s1 + s2 the corotated law's energy is smooth but for
//   V c z,   c = lambda (s0 - 3) - 2 mu,
// where z >= 0 is the length of a vector of two: of how an element widens across, and how it turns
// about its long axis. Where c > 0 that is a cone, and its tip, z = 0, is the least energy across:
// drawn out by more than 3 + 2 mu / lambda an element ends there. The stiffness that holds
// rotations still knows nothing of it; along its direction the element goes through the tip, and
// the kink there cuts the step of the whole body to nothing. So
//   d^T C d = V c / z |dz|^2,
// the least parabola that lies nowhere below the cone, is added to the matrix of a step, and, for
// the part that turns, the V (mu + lambda) of the smooth rest, which that stiffness lacks, too. To
// the matrix only: energies, forces and damping are without.
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

// Of the elements whose stiffness is written in factors. Keeps references. Not thread-safe.
class CollapseStiffness {
  public:
    CollapseStiffness(const Body& body, const AssemblyPlan& plan, const LiveSet& live)
        : body_(body), plan_(plan), live_(live) {}

    // Which live elements have collapsed, at the positions where `slots` found the energies last.
    // One comparison an element, and a singular value decomposition where that may be.
    void find(const ElementSlots& slots, std::span<const Vec3> positions_mm);
    bool any() const { return !collapsed_.empty(); }
    // To be called after the body's nodes were split.
    void forget() {
        collapsed_.clear();
        least_nj_.clear();
    }

    // Adds factor * C, without the rows and columns of held nodes.
    void add_to(BlockMatrix& matrix, double factor) const;
    // Adds factor * C d; d is 0 where a node is held, and rows of such nodes mean nothing.
    void add_product(std::span<const Vec3> d, double factor, std::span<Vec3> product) const;

  private:
    // The two parts of dz, times the roots of their stiffnesses: sums of widens[a] . d_a and of
    // turns[a] . d_a.
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
    // Of every element of each group in factors: what it stores at least once it has collapsed.
    std::vector<std::vector<double>> least_nj_;
};

}  // namespace hepatica
