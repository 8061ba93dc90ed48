// SPDX-License-Identifier: GPL-3.0-or-later
// Counts false joins in three steps: drop short stretches, mark the samples where systems meet, and
// count the connected neighbourhoods of these.
#include "core/accuracy/false_joins.h"

#include <queue>
#include <set>

#include "core/base/disjoint_sets.h"

namespace hepatica {

namespace {

using Systems = std::vector<std::uint8_t>;

bool is_judged(const CentrelineSamples& tree, const CentrelineStep& step) {
    return tree.samples[step.from].judged && tree.samples[step.to].judged;
}

// Connected stretches of judged samples of one system (0: none), as sets of samples.
DisjointSets stretches(const CentrelineSamples& tree, const Systems& systems) {
    DisjointSets sets(tree.samples.size());
    for (const CentrelineStep& step : tree.steps)
        if (is_judged(tree, step) && systems[step.from] == systems[step.to])
            sets.unite(step.from, step.to);
    return sets;
}

// The systems of the samples; 0 for stretches shorter than stray_mm.
Systems without_strays(const CentrelineSamples& tree, std::span<const std::uint8_t> truth,
                       double stray_mm) {
    Systems systems(truth.begin(), truth.end());
    DisjointSets sets = stretches(tree, systems);
    std::vector<double> length(tree.samples.size(), 0.0);
    for (const CentrelineStep& step : tree.steps)
        if (is_judged(tree, step) && systems[step.from] == systems[step.to])
            length[sets.root(step.from)] += step.length_mm;
    for (std::size_t i = 0; i < systems.size(); ++i)
        if (length[sets.root(static_cast<std::uint32_t>(i))] < stray_mm) systems[i] = 0;
    return systems;
}

// Marks the samples at which systems meet: both ends of a step between two systems, and stretches
// of no system that lie between different ones.
std::vector<std::uint8_t> meetings(const CentrelineSamples& tree, const Systems& systems) {
    DisjointSets sets = stretches(tree, systems);
    std::vector<std::set<std::uint8_t>> beside(systems.size());
    std::vector<std::uint8_t> meets(systems.size(), 0);
    for (const CentrelineStep& step : tree.steps) {
        const std::uint8_t a = systems[step.from], b = systems[step.to];
        if (!is_judged(tree, step) || a == b) continue;
        if (a != 0 && b != 0) meets[step.from] = meets[step.to] = 1;
        if (a == 0) beside[sets.root(step.from)].insert(b);
        if (b == 0) beside[sets.root(step.to)].insert(a);
    }
    for (std::size_t i = 0; i < systems.size(); ++i)
        if (systems[i] == 0 && beside[sets.root(static_cast<std::uint32_t>(i))].size() > 1)
            meets[i] = 1;
    return meets;
}

// Grows the meetings along the tree by their radii plus place_mm (Dijkstra's algorithm on the
// remaining reach). Returns which samples belong to a place.
std::vector<std::uint8_t> grown(const CentrelineSamples& tree,
                                const std::vector<std::uint8_t>& meets, double place_mm) {
    std::vector<std::vector<std::pair<int, double>>> beside(tree.samples.size());
    for (const CentrelineStep& step : tree.steps) {
        if (!is_judged(tree, step)) continue;
        beside[step.from].emplace_back(step.to, step.length_mm);
        beside[step.to].emplace_back(step.from, step.length_mm);
    }
    std::vector<double> reach(tree.samples.size(), -1.0);
    std::priority_queue<std::pair<double, int>> queue;
    for (std::size_t i = 0; i < meets.size(); ++i)
        if (meets[i] != 0)
            queue.emplace(reach[i] = tree.samples[i].radius_mm + place_mm, static_cast<int>(i));
    while (!queue.empty()) {
        const auto [left, at] = queue.top();
        queue.pop();
        if (left < reach[at]) continue;
        for (const auto& [next, length] : beside[at])
            if (left - length > reach[next] && left >= length)
                queue.emplace(reach[next] = left - length, next);
    }
    std::vector<std::uint8_t> place(reach.size(), 0);
    for (std::size_t i = 0; i < reach.size(); ++i) place[i] = reach[i] >= 0.0;
    return place;
}

}  // namespace

int count_false_joins(const CentrelineSamples& tree, std::span<const std::uint8_t> truth,
                      const JoinOptions& options) {
    const Systems systems = without_strays(tree, truth, options.stray_mm);
    const std::vector<std::uint8_t> place = grown(tree, meetings(tree, systems), options.place_mm);
    DisjointSets sets(place.size());
    for (const CentrelineStep& step : tree.steps)
        if (is_judged(tree, step) && place[step.from] != 0 && place[step.to] != 0)
            sets.unite(step.from, step.to);
    std::set<std::uint32_t> places;
    for (std::size_t i = 0; i < place.size(); ++i)
        if (place[i] != 0) places.insert(sets.root(static_cast<std::uint32_t>(i)));
    return static_cast<int>(places.size());
}

}  // namespace hepatica
