// SPDX-License-Identifier: GPL-3.0-or-later
// Runs Dijkstra's algorithm twice: for the shortest path and for the path with the strongest
// weakest piece.
#include "core/links/way_to_sure.h"

#include <algorithm>
#include <functional>
#include <queue>
#include <utility>

namespace hepatica {

namespace {

// Dijkstra's algorithm over neighbouring pieces: lowers the given costs along all paths. Ties are
// settled in the order of the pieces.
std::vector<double> settled(const std::vector<LinePiece>& pieces, std::vector<double> cost,
                            const std::function<double(double, int, int)>& cost_through) {
    using Entry = std::pair<double, int>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> waiting;
    for (std::size_t i = 0; i < cost.size(); ++i) waiting.emplace(cost[i], static_cast<int>(i));
    while (!waiting.empty()) {
        const auto [here, at] = waiting.top();
        waiting.pop();
        if (here > cost[at]) continue;
        for (const int next : pieces[at].neighbours) {
            const double there = cost_through(here, at, next);
            if (there >= cost[next]) continue;
            cost[next] = there;
            waiting.emplace(there, next);
        }
    }
    return cost;
}

}  // namespace

std::vector<WayToSure> ways_to_sure(const std::vector<LinePiece>& pieces,
                                    std::span<const double> lines,
                                    std::span<const double> radii_mm) {
    std::vector<double> far(pieces.size()), weak(pieces.size());
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const bool sure = lines[i] >= sure_line && radii_mm[i] >= sure_radius_mm;
        far[i] = sure ? 0.0 : farthest_sure_mm;
        weak[i] = sure ? -lines[i] : 0.0;
    }
    far = settled(pieces, std::move(far), [&](double here, int at, int next) {
        return here + 0.5 * (pieces[at].length_mm + pieces[next].length_mm);
    });
    weak = settled(pieces, std::move(weak),
                   [&](double here, int, int next) { return std::max(here, -lines[next]); });
    std::vector<WayToSure> ways(pieces.size());
    for (std::size_t i = 0; i < pieces.size(); ++i) ways[i] = {far[i], -weak[i]};
    return ways;
}

}  // namespace hepatica
