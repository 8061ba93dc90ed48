// SPDX-License-Identifier: GPL-3.0-or-later
// The resistance of taut elements to being turned. The stiffness of the linear corotated element
// holds its rotation still and leaves out that a stretched one pulls back when it is turned; along
// its direction a step then goes too far. For a uniaxial stress s that part is
//   d^T T d = V s / 4 |sum_a h_a x d_a|^2,   h_a the turned gradient of node a's shape function.
// Here s is the trace of the stress, taken as the mean over all elements at the element's nodes, so
// that the two sides of a bent vessel cancel, and 0 where it is pressed together: T is positive
// semidefinite. It belongs to the matrix of a step only: energies, forces and damping are without.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/deform/body/body.h"
#include "core/deform/solvers/block_matrix.h"
#include "core/deform/step/assembly_plan.h"
#include "core/deform/step/element_slots.h"
#include "core/deform/step/live_set.h"

namespace hepatica {

// Of the elements whose stiffness is written in factors; others count as slack. Keeps references.
// Not thread-safe; the same bits for any number of threads.
class TensionStiffness {
  public:
    TensionStiffness(const Body& body, const AssemblyPlan& plan, const LiveSet& live);

    // Which live elements are taut, at the positions of the slots' last evaluation.
    void find(const ElementSlots& slots);
    bool any() const { return !rows_.empty(); }

    // Computes factor * T by the turned gradients in the slots.
    void make(const ElementSlots& slots, double factor);
    // Adds share times what was made, without the rows and columns of held nodes.
    void add_to(BlockMatrix& matrix, double share) const;
    // product -= T d in rows of nodes that are not held; d is 0 where a node is held.
    void subtract_product(std::span<const Vec3> d, std::span<Vec3> product) const;

  private:
    struct Taut {
        int element;
        double share;  // the mean pull over twice the shear modulus
    };
    struct Place {
        int group, element;
    };

    void find_mean_pulls(const ElementSlots& slots);
    double tautness(std::size_t group, int element) const;
    std::vector<std::vector<Taut>> taut_of(std::size_t group) const;
    Mat3 upper_block(const ElementSlots& slots, int k) const;

    const Body& body_;
    const AssemblyPlan& plan_;
    const LiveSet& live_;
    std::vector<std::vector<double>> twice_mu_pa_;  // of each element of every group in factors
    // Of each node: its elements of these groups, and their volume.
    std::vector<std::size_t> node_begin_{0};
    std::vector<Place> at_node_;
    std::vector<double> volume_mm3_;
    std::vector<double> mean_pull_pa_;
    std::vector<double> tautness_;         // at each force slot
    std::vector<int> taut_slots_;          // whose tautness is not 0
    std::vector<std::uint8_t> taut_node_;  // 1: of a taut element
    std::vector<int> rows_;                // these nodes, ascending
    std::vector<std::size_t> row_begin_;   // of each of them: its first block
    std::vector<Mat3> block_;              // as the plan has them
};

}  // namespace hepatica
