// SPDX-License-Identifier: GPL-3.0-or-later
// The state of tearing, as plain data: what a checkpoint must hold to continue it, and what a frame
// shows.
#pragma once

#include <vector>

namespace hepatica {

// Everything except mesh and law that determines the next steps.
struct TearState {
    std::vector<int> parents;      // of the vertices that were split off, in their order
    std::vector<int> tetrahedra;   // those with changed corners, ascending,
    std::vector<int> corners;      // and their corners, four each
    std::vector<int> parted;       // joints, ascending,
    std::vector<double> most_mm;   // and the largest opening of the three corners of each
    std::vector<int> weakened;     // joints, ascending,
    std::vector<double> weakness;  // and the factor of each
    bool begun = false;            // a vertex was split
    bool stopped = false;
    double entropy_before_nats = 0.0;  // at the first split; -1: not strained then
    double entropy_nats = 0.0;         // at the end of the last step
};

// What a frame shows of the tear.
struct TearReport {
    int joints_parted = 0;
    int joints_broken = 0;       // completely come apart
    double torn_area_mm2 = 0.0;  // at rest, of what nothing binds any more: a third of a joint's
                                 // for each of its corners
    int vertices_split = 0;
    int pieces = 1;
    int pieces_off = 0;  // more than the whole body has
    double entropy_nats = 0.0;
    double entropy_produced_nats = 0.0;  // since the first split, >= 0
    bool stopped = false;                // by the law's stop criterion
    bool operator==(const TearReport&) const = default;
};

}  // namespace hepatica
