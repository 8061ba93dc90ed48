// SPDX-License-Identifier: GPL-3.0-or-later
// Which part of a vessel tree is computed (live): the nodes of its skeleton near a tool, and those
// that move. All others are frozen in place. Each vertex belongs to one skeleton node.
#pragma once

#include <span>
#include <vector>

#include "core/deform/solvers/coarse_skeleton.h"
#include "core/deform/stepper/stepper_checkpoint.h"

namespace hepatica {

struct LiveRegionOptions {
    // A frozen node wakes when a live neighbour (half a diameter away) has moved by this share of
    // its radius since the border between them arose. This bounds the change of strain at a border,
    // even for slow motion and frequent changes of the region.
    double wake_radii = 1e-4;
    // A live node may freeze after moving slower than still_radii_per_s radii per second ...
    double still_radii_per_s = 5e-4;
    // ... for still_s seconds.
    double still_s = 0.5;
    // Nodes up to this many edges from a waking or held node wake with it; two edges are about one
    // diameter.
    int reach_nodes = 8;
};

class LiveRegion {
  public:
    // All nodes are live at first. Throws InputError for an empty or invalid skeleton.
    LiveRegion(const CoarseSkeleton& skeleton, std::span<const Vec3> rest_positions_mm,
               const LiveRegionOptions& options = {});

    // Makes neighbours of the skeleton nodes of these vertices, which share an element. Needed for
    // elements that connect nodes without a skeleton edge between them; may be called for all
    // elements.
    void connect(std::span<const int> vertices);

    // To be called after vertices were split (see TornTopology): new ones belong to their parents'
    // nodes.
    void follow_split(std::span<const int> parents);

    const LiveRegionOptions& options() const { return options_; }
    void wake_all();
    // Wakes the nodes around these vertices and keeps them live until the next call. Returns
    // whether any node woke.
    bool hold(std::span<const int> vertices);
    // Wakes the nodes around these vertices once. Returns whether any node woke.
    bool wake(std::span<const int> vertices);
    // To be called after a step with the positions and velocities of all vertices. Returns whether
    // the region changed: it grows at once, and shrinks when a quarter of its nodes has been still
    // for still_s.
    bool watch(std::span<const Vec3> positions_mm, std::span<const Vec3> velocities_mm_per_s,
               double dt_s);

    // The region's state. restore() throws InputError and changes nothing where the checkpoint is
    // not of a region of this skeleton.
    RegionCheckpoint checkpoint() const;
    void restore(const RegionCheckpoint& checkpoint);

    bool live(int vertex) const { return live_[node_of_[vertex]] != 0; }
    // Whether the vertex' node is live and has moved within the last still_s.
    bool restless(int vertex) const {
        return live(vertex) && still_s_[node_of_[vertex]] < options_.still_s;
    }
    const std::vector<char>& live_nodes() const { return live_; }
    int live_count() const;

  private:
    bool wake_around(std::span<const int> nodes);
    bool borders_on_frozen(std::size_t node) const;
    std::vector<char> nodes_at_borders() const;
    void refer_to(std::span<const Vec3> positions_mm, const std::vector<char>& bordered_before);

    CoarseSkeleton skeleton_;
    LiveRegionOptions options_;
    std::vector<int> node_of_;                   // of each vertex
    std::vector<std::vector<int>> vertices_of_;  // of each node
    std::vector<std::vector<int>> neighbours_;   // nodes that share an edge or an element
    std::vector<char> live_;
    std::vector<double> still_s_;
    std::vector<int> held_;  // nodes
    // Positions of the vertices of each node when the first of its frozen neighbours froze; unused
    // for nodes without frozen neighbours.
    std::vector<Vec3> reference_mm_;
};

}  // namespace hepatica
