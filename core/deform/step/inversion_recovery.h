// SPDX-License-Identifier: GPL-3.0-or-later
// A body that was forced through itself may settle in another state of equilibrium, with elements
// turned inside out that no motion of least resistance turns back. Such a state is none that tissue
// can be in. This looks for one that is: the smallest patch around the inverted elements that,
// put where linear elasticity spans it between its surroundings, is inverted nowhere.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "core/deform/body/body.h"

namespace hepatica {

// Elements of the body that are turned inside out or flat at a corner or an integration point, as
// indices counted through its groups.
std::vector<int> inverted_elements(const Body& body, std::span<const Vec3> positions_mm);

// Keeps a reference to the body. Not thread-safe; the same bits for any number of threads.
class InversionRecovery {
  public:
    explicit InversionRecovery(const Body& body) : body_(body) {}

    // Positions without inverted elements, or none where nothing is inverted or no patch helps.
    // `energy` is that of elements, springs and weight at given positions; it is lower at the ones
    // returned, so that a body cannot be recovered again and again. Costs one look at every
    // element, an energy for every patch that came out right, and linear solves over the patches
    // alone: of most_unknowns in all, each of so many iterations at most. What a body of that size
    // does not recover from stays as it is.
    using Energy = std::function<double(std::span<const Vec3> positions_mm)>;
    std::optional<std::vector<Vec3>> recover(std::span<const Vec3> positions_mm,
                                             const Energy& energy);

    static constexpr int most_unknowns = 12000;
    static constexpr int most_iterations = 300;

    // Coordinates of the nodes that the last call to recover() solved for, all patches together.
    int unknowns() const { return unknowns_; }

  private:
    // Marks nodes, each of which is in the patch once.
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
