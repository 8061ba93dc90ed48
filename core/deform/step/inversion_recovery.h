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
#include "core/deform/step/assembly.h"

namespace hepatica {

// Elements of the body that are turned inside out or flat at a corner or an integration point, as
// indices counted through its groups.
std::vector<int> inverted_elements(const Body& body, std::span<const Vec3> positions_mm);

// Keeps a reference to the body. Not thread-safe; the same bits for any number of threads.
class Unfolding {
  public:
    explicit Unfolding(const Body& body) : body_(body) {}

    // Positions without the folds, or none where nothing is inverted or no patch helps. `energy` is
    // that of elements, springs and weight at given positions; it is lower at the ones returned, so
    // that a body cannot be unfolded again and again. Costs a few linear solves over the patch.
    using Energy = std::function<double(std::span<const Vec3> positions_mm)>;
    std::optional<std::vector<Vec3>> unfold(std::span<const Vec3> positions_mm,
                                            const Energy& energy);

  private:
    std::vector<char> nodes_of(const std::vector<int>& elements) const;
    void grow(std::vector<char>& patch) const;
    std::vector<Vec3> span_patch(const std::vector<char>& patch,
                                 std::span<const Vec3> positions_mm) const;

    const Body& body_;
    BlockMatrix stiffness_;  // at rest; empty until it is needed
};

}  // namespace hepatica
