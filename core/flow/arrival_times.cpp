// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/flow/arrival_times.h"

#include <algorithm>
#include <cmath>
#include <queue>

namespace hepatica {

namespace {

constexpr double never = std::numeric_limits<double>::infinity();

// `slack` absorbs the rounding of volumes at the ends of a segment.
double interpolate(const std::vector<ArrivalTimes::Knot>& knots, double volume_mm3, double slack) {
    if (knots.empty() || volume_mm3 < knots.front().volume_mm3 - slack ||
        volume_mm3 > knots.back().volume_mm3 + slack)
        return never;
    const auto above =
        std::ranges::upper_bound(knots, volume_mm3, {}, &ArrivalTimes::Knot::volume_mm3);
    if (above == knots.end()) return knots.back().time_s;
    if (above == knots.begin()) return above->time_s;
    const auto below = above - 1;
    const double share = (volume_mm3 - below->volume_mm3) / (above->volume_mm3 - below->volume_mm3);
    return below->time_s + share * (above->time_s - below->time_s);
}

}  // namespace

ArrivalTimes::ArrivalTimes(const FlowNetwork& network)
    : network_(network),
      from_proximal_(network.segments.size()),
      from_distal_(network.segments.size()) {}

void ArrivalTimes::set_from_proximal(int segment, std::vector<Knot> knots) {
    from_proximal_[segment] = std::move(knots);
}

void ArrivalTimes::set_from_distal(int segment, std::vector<Knot> knots) {
    from_distal_[segment] = std::move(knots);
}

double ArrivalTimes::at_volume(int segment, double volume) const {
    const double slack = 1e-12 * volume_mm3(network_, segment);
    return std::min(interpolate(from_proximal_[segment], volume, slack),
                    interpolate(from_distal_[segment], volume, slack));
}

double ArrivalTimes::arrival_s(int segment, double arclength_mm) const {
    return at_volume(segment, volume_up_to_mm3(network_, segment, arclength_mm));
}

double ArrivalTimes::arrival_s(const TreePoint& point) const {
    const NetworkPoint at = locate(network_, point);
    return arrival_s(at.segment, at.arclength_mm);
}

double ArrivalTimes::first_s(int segment) const {
    double first = never;
    for (const auto* knots : {&from_proximal_[segment], &from_distal_[segment]})
        for (const Knot& knot : *knots) first = std::min(first, knot.time_s);
    return first;
}

double ArrivalTimes::end_s() const {
    double end = 0.0;
    for (const auto* side : {&from_proximal_, &from_distal_})
        for (const std::vector<Knot>& knots : *side)
            for (const Knot& knot : knots)
                if (std::isfinite(knot.time_s)) end = std::max(end, knot.time_s);
    return end;
}

ArrivalTimes arrival_times(const FlowNetwork& network, const FlowSolution& solution,
                           const std::vector<int>& source_nodes) {
    ArrivalTimes times(network);
    const NodeSegments at = segments_at_nodes(network);
    double largest = 0.0;
    for (const double q : solution.volume_flow_mm3_s) largest = std::max(largest, std::abs(q));
    std::vector<double> node_time(network.node_count, never);
    using Entry = std::pair<double, int>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    for (const int node : source_nodes) {
        node_time[node] = 0.0;
        queue.emplace(0.0, node);
    }
    // Dijkstra's order: the earliest unsettled node cannot be reached any earlier.
    while (!queue.empty()) {
        const auto [time, node] = queue.top();
        queue.pop();
        if (time > node_time[node]) continue;
        for (int i = at.first[node]; i < at.first[node + 1]; ++i) {
            const int segment = at.segments[i];
            const FlowSegment& s = network.segments[segment];
            const double q = solution.volume_flow_mm3_s[segment];
            const bool from_proximal = s.proximal_node == node;
            if (!s.open || (from_proximal ? q : -q) <= 1e-14 * largest) continue;
            const double volume = volume_mm3(network, segment);
            const double reached = time + volume / std::abs(q);
            if (from_proximal)
                times.set_from_proximal(segment, {{0.0, time}, {volume, reached}});
            else
                times.set_from_distal(segment, {{0.0, reached}, {volume, time}});
            const int other = from_proximal ? s.distal_node : s.proximal_node;
            if (reached < node_time[other]) {
                node_time[other] = reached;
                queue.emplace(reached, other);
            }
        }
    }
    return times;
}

}  // namespace hepatica
