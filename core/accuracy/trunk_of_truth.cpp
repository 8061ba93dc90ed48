// SPDX-License-Identifier: GPL-3.0-or-later
// Sums lengths and volumes beyond each sample of a spanning tree from the widest judged sample, and
// picks the largest part that leads to nothing judged.
#include "core/accuracy/trunk_of_truth.h"

#include <vector>

namespace hepatica {

namespace {

// A breadth-first walk from one sample.
struct Walk {
    std::vector<int> order;
    std::vector<int> from;  // by sample; -1 at the first one and at samples that were not reached
};

Walk walk_from(int start, const std::vector<std::vector<int>>& beside) {
    Walk walk{{start}, std::vector<int>(beside.size(), -1)};
    std::vector<std::uint8_t> seen(beside.size(), 0);
    seen[start] = 1;
    for (std::size_t k = 0; k < walk.order.size(); ++k)
        for (const int next : beside[walk.order[k]]) {
            if (seen[next] != 0) continue;
            seen[next] = 1;
            walk.from[next] = walk.order[k];
            walk.order.push_back(next);
        }
    return walk;
}

std::vector<std::vector<int>> neighbours(const CentrelineSamples& line) {
    std::vector<std::vector<int>> beside(line.samples.size());
    for (const CentrelineStep& step : line.steps) {
        beside[step.from].push_back(step.to);
        beside[step.to].push_back(step.from);
    }
    return beside;
}

// Length and volume (without the factor pi) beyond a sample, itself included.
struct Beyond {
    double judged_mm = 0.0, other_mm = 0.0, other_mm3 = 0.0;
};

std::vector<Beyond> beyond_samples(const CentrelineSamples& line, const Walk& walk) {
    std::vector<Beyond> beyond(line.samples.size());
    for (std::size_t k = walk.order.size(); k-- > 0;) {
        const int i = walk.order[k];
        const CentrelineSample& sample = line.samples[i];
        if (sample.judged) {
            beyond[i].judged_mm += sample.weight_mm;
        } else {
            beyond[i].other_mm += sample.weight_mm;
            beyond[i].other_mm3 += sample.weight_mm * sample.radius_mm * sample.radius_mm;
        }
        if (walk.from[i] < 0) continue;
        Beyond& before = beyond[walk.from[i]];
        before.judged_mm += beyond[i].judged_mm;
        before.other_mm += beyond[i].other_mm;
        before.other_mm3 += beyond[i].other_mm3;
    }
    return beyond;
}

// The widest judged sample, which lies on the path to most of the judged centrelines.
std::optional<int> widest_judged(const CentrelineSamples& line) {
    std::optional<int> widest;
    for (std::size_t i = 0; i < line.samples.size(); ++i)
        if (line.samples[i].judged &&
            (!widest || line.samples[i].radius_mm > line.samples[*widest].radius_mm))
            widest = static_cast<int>(i);
    return widest;
}

}  // namespace

std::optional<int> end_of_trunk(const CentrelineSamples& line) {
    const std::optional<int> start = widest_judged(line);
    if (!start) return std::nullopt;
    const Walk walk = walk_from(*start, neighbours(line));
    const std::vector<Beyond> beyond = beyond_samples(line, walk);
    std::optional<int> end;
    double most_mm3 = 0.0;
    for (const int i : walk.order) {
        const int from = walk.from[i];
        const bool hangs = from >= 0 && beyond[i].judged_mm < usual_stray_mm &&
                           (from == *start || beyond[from].judged_mm >= usual_stray_mm);
        if (!hangs || beyond[i].other_mm < usual_stray_mm || beyond[i].other_mm3 <= most_mm3)
            continue;
        most_mm3 = beyond[i].other_mm3;
        end = from;
    }
    return end;
}

}  // namespace hepatica
