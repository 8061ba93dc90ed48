// SPDX-License-Identifier: GPL-3.0-or-later
// When an injected fluid first reaches each place of the network. In a steady flow of one fluid
// this is the integral of A/Q along the path from the tip, in closed form; the stepped front
// (drug_front.h) writes its history into the same table.
#pragma once

#include <limits>
#include <vector>

#include "core/flow/flow_network.h"
#include "core/flow/flow_solution.h"

namespace hepatica {

// Arrival along each segment as a piecewise linear function of the filled volume, which is exact
// for any taper while the flow is steady. Thread-safe to read once it is filled.
class ArrivalTimes {
  public:
    struct Knot {
        double volume_mm3 = 0.0;  // of the segment, from its proximal node
        double time_s = 0.0;
    };

    ArrivalTimes() = default;
    explicit ArrivalTimes(const FlowNetwork& network);

    // Knots of one segment, ascending in volume. A segment that is filled from both ends has two
    // lists.
    void set_from_proximal(int segment, std::vector<Knot> knots);
    void set_from_distal(int segment, std::vector<Knot> knots);

    // Seconds since the injection began; infinity where the fluid never comes. `arclength_mm` is
    // clamped to the segment. The first function takes a segment of the network, the second one of
    // the tree.
    double arrival_s(int segment, double arclength_mm) const;
    double arrival_s(const TreePoint& point) const;

    // When a segment is first reached.
    double first_s(int segment) const;
    // When the last of all reached places is reached; 0 if there is none.
    double end_s() const;

  private:
    double at_volume(int segment, double volume_mm3) const;

    FlowNetwork network_;
    std::vector<std::vector<Knot>> from_proximal_;
    std::vector<std::vector<Knot>> from_distal_;
};

// The closed form: fluid enters at `source_nodes` at time 0 and has the properties of the fluid
// that it displaces. Where paths meet (loops) the earliest counts. Flows below 1e-14 of the largest
// count as 0.
ArrivalTimes arrival_times(const FlowNetwork& network, const FlowSolution& solution,
                           const std::vector<int>& source_nodes);

}  // namespace hepatica
