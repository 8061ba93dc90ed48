// SPDX-License-Identifier: GPL-3.0-or-later
// Which stretches of a vessel tree a scene has to compute: those near the tool and those that move.
// The rest is frozen where it is. Counted in skeleton nodes; a vertex belongs to one of them.
#pragma once

#include <span>
#include <vector>

#include "core/deform/solvers/coarse_skeleton.h"
#include "core/deform/stepper/stepper_checkpoint.h"

namespace hepatica {

struct LiveRegionOptions {
    // A frozen stretch wakes when the live one beside it, half a diameter away, has moved by this
    // share of its radius since the border between them arose: a change of strain there, however
    // slowly it comes and however often the region changes meanwhile.
    double wake_radii = 1e-4;
    // A live node that is slower than this share of its radius a second ...
    double still_radii_per_s = 5e-4;
    // ... for this long may freeze.
    double still_s = 0.5;
    // Nodes around whatever wakes or is held that wake, too: two of them are a diameter.
    int reach_nodes = 8;
};

class LiveRegion {
  public:
    // Everything is live at first. Throws InputError for an empty or broken skeleton.
    LiveRegion(const CoarseSkeleton& skeleton, std::span<const Vec3> rest_positions_mm,
               const LiveRegionOptions& options = {});

    // The vertices share an element: where one moves, the others feel it. To be called for every
    // element that joins stretches which are no neighbours on the skeleton (or simply for all).
    void connect(std::span<const int> vertices);

    void wake_all();
    // Wakes the surroundings of these vertices and keeps them live until the next call.
    // Returns whether anything woke.
    bool hold(std::span<const int> vertices);
    // Takes a step's outcome (of all vertices). Returns whether the region changed: it grows at
    // once, and shrinks when a quarter of it has been still for long enough.
    bool watch(std::span<const Vec3> positions_mm, std::span<const Vec3> velocities_mm_per_s,
               double dt_s);

    // live, still_s, held and reference_mm of a RegionCheckpoint. restore() takes them; it throws
    // InputError where they are not of a region of this skeleton, and then changes nothing.
    RegionCheckpoint checkpoint() const;
    void restore(const RegionCheckpoint& checkpoint);

    bool live(int vertex) const { return live_[node_of_[vertex]] != 0; }
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
    // Where the vertices of each node were when the first of its neighbours that are frozen froze;
    // of no meaning where none is.
    std::vector<Vec3> reference_mm_;
};

}  // namespace hepatica
