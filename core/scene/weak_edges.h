// SPDX-License-Identifier: GPL-3.0-or-later
// Where a cut line shows on the vessels: the edges of the surface at which a weakened joint still
// holds. Found anew only where another joint is weak or something has torn.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace hepatica {

class Tearing;

// Not thread-safe; what it returned stays as it is.
class WeakEdges {
  public:
    using Edges = std::shared_ptr<const std::vector<std::array<int, 2>>>;

    // Pairs of vertices, each with the smaller first, ascending. Null where there are none.
    Edges of(const Tearing& tearing);

  private:
    std::vector<int> joints_;    // that were weak
    std::uint64_t version_ = 0;  // of the topology
    int vertices_ = 0;           // likewise
    Edges edges_;
};

}  // namespace hepatica
