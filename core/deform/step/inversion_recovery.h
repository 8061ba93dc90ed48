// SPDX-License-Identifier: GPL-3.0-or-later
// A body that was forced through itself may settle in an equilibrium with inverted elements, which
// the forces do not restore and which real tissue cannot have. This class finds positions without
// inversion: it moves the smallest patch around the inverted elements to the solution of linear
// elasticity with the surrounding nodes as boundary values, and enlarges the patch until no element
// is inverted. A loose piece without surrounding nodes gets back its shape where it is.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "core/deform/body/body.h"

namespace hepatica {

// Elements that are inverted or flat at a corner or an integration point, as indices numbered
// through the groups of the body.
std::vector<int> inverted_elements(const Body& body, std::span<const Vec3> positions_mm);

// Keeps a reference to the body. Not thread-safe; the same bits for any number of threads.
class InversionRecovery {
  public:
    explicit InversionRecovery(const Body& body) : body_(body) {}

    // Returns positions without inverted elements; none where nothing is inverted or no patch
    // helps. `energy` must give the energy of elements, springs and weight at given positions; it
    // is lower at the returned positions, so that recoveries cannot cycle. The cost is bounded: one
    // check of every element, one energy per successful patch, and linear solves over patches with
    // at most most_unknowns in total and at most most_iterations each. Larger inversions are left.
    using Energy = std::function<double(std::span<const Vec3> positions_mm)>;
    std::optional<std::vector<Vec3>> recover(std::span<const Vec3> positions_mm,
                                             const Energy& energy);

    static constexpr int most_unknowns = 12000;
    static constexpr int most_iterations = 300;

    // Total number of unknowns solved for in the last call to recover().
    int unknowns() const { return unknowns_; }

  private:
    // A set of nodes.
    struct Patch {
        std::vector<int> nodes;
        std::vector<int> index;  // per node of the body: its index in `nodes`; -1: not in the patch
    };

    void find_elements_of_nodes();
    void add_nodes_of(int element, Patch& patch) const;
    void grow(Patch& patch) const;
    std::vector<int> elements_around(const Patch& patch) const;
    std::optional<std::vector<Vec3>> span_patch(const Patch& patch,
                                                std::span<const Vec3> positions_mm);

    const Body& body_;
    // Elements of node i: element_[first_element_[i]] to element_[first_element_[i + 1]]; empty
    // until something is inverted.
    std::vector<int> first_element_, element_;
    std::vector<int> first_of_group_;
    int unknowns_ = 0;
};

}  // namespace hepatica
