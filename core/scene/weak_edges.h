// SPDX-License-Identifier: GPL-3.0-or-later
// How a cut line is shown on the vessels: the surface edges of weakened joints that still hold.
// Computed again only where the weakened joints or the topology change.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace hepatica {

class Tearing;

// Not thread-safe; returned edges are never changed.
class WeakEdges {
  public:
    using Edges = std::shared_ptr<const std::vector<std::array<int, 2>>>;

    // Pairs of vertices, each with the smaller first, ascending. Null where there are none.
    Edges of(const Tearing& tearing);

  private:
    std::vector<int> joints_;    // that were weakened
    std::uint64_t version_ = 0;  // of the topology
    int vertices_ = 0;           // of the topology
    Edges edges_;
};

}  // namespace hepatica
