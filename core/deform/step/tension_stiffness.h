// SPDX-License-Identifier: GPL-3.0-or-later
// The rotational stiffness of taut elements. The stiffness of the linear corotated element keeps
// its rotation fixed and so misses that a stretched element resists rotation; without that, the
// direction of a step overshoots. For a uniaxial stress s the missing part is
//   d^T T d = V s / 4 |sum_a h_a x d_a|^2,   h_a the turned gradient of node a's shape function.
// Here s is the trace of the stress, averaged over all elements at the element's nodes, so that the
// two sides of a bent vessel cancel, and 0 under compression: T is positive semidefinite. It
// belongs to the matrix of a step only: energies, forces and damping do not contain it.
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

// For the elements whose stiffness is written in factors; others count as slack. Keeps references.
// Not thread-safe; the same bits for any number of threads.
class TensionStiffness {
  public:
    TensionStiffness(const Body& body, const AssemblyPlan& plan, const LiveSet& live);

    // Finds the taut live elements at the positions of the slots' last evaluation.
    void find(const ElementSlots& slots);
    bool any() const { return !rows_.empty(); }

    // Computes factor * T from the turned gradients in the slots.
    void make(const ElementSlots& slots, double factor);
    // Adds share times the result of make(), without the rows and columns of held nodes.
    void add_to(BlockMatrix& matrix, double share) const;
    // product -= T d in rows of nodes that are not held; d must be 0 at held nodes.
    void subtract_product(std::span<const Vec3> d, std::span<Vec3> product) const;

  private:
    struct Taut {
        int element;
        double share;  // mean pull over twice the shear modulus
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
    // For each node: its elements in these groups, and their volume.
    std::vector<std::size_t> node_begin_{0};
    std::vector<Place> at_node_;
    std::vector<double> volume_mm3_;
    std::vector<double> mean_pull_pa_;
    std::vector<double> tautness_;         // at each force slot
    std::vector<int> taut_slots_;          // slots with a nonzero tautness
    std::vector<std::uint8_t> taut_node_;  // 1: a node of a taut element
    std::vector<int> rows_;                // these nodes, ascending
    std::vector<std::size_t> row_begin_;   // first block of each of them
    std::vector<Mat3> block_;              // in the order of the plan
};

}  // namespace hepatica
