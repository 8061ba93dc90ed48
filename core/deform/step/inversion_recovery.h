// SPDX-License-Identifier: GPL-3.0-or-later
// A body that was forced through itself may settle in an equilibrium with inverted elements, which
// the forces do not turn back and which tissue cannot have. This finds positions without inversion:
// it moves the smallest patch around the inverted elements to the solution of linear elasticity
// with the nodes around the patch as boundary values, and enlarges the patch until no element is
// inverted.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "core/deform/body/body.h"

namespace hepatica {

// Elements that are inverted or flat at a corner or an integration point, as indices counted
// through the groups of the body.
std::vector<int> inverted_elements(const Body& body, std::span<const Vec3> positions_mm);

// Keeps a reference to the body. Not thread-safe; the same bits for any number of threads.
class InversionRecovery {
  public:
    explicit InversionRecovery(const Body& body) : body_(body) {}

    // Returns positions without inverted elements; none where nothing is inverted or no patch
    // helps. `energy` gives the energy of elements, springs and weight at given positions. It is
    // lower at the positions returned, so that recoveries cannot repeat without end. The cost is
    // bounded: one check of every element, one energy for every successful patch, and linear solves
    // over patches with at most most_unknowns in total, of at most most_iterations each. Larger
    // inversions stay.
    using Energy = std::function<double(std::span<const Vec3> positions_mm)>;
    std::optional<std::vector<Vec3>> recover(std::span<const Vec3> positions_mm,
                                             const Energy& energy);

    static constexpr int most_unknowns = 12000;
    static constexpr int most_iterations = 300;

    // Number of unknowns of all solves of the last call to recover().
    int unknowns() const { return unknowns_; }

  private:
    // A set of nodes.
    struct Patch {
        std::vector<int> nodes;
        std::vector<int> index;  // of each node of the body; -1: not in the patch
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
