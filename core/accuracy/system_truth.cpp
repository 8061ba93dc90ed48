// SPDX-License-Identifier: GPL-3.0-or-later
// Skeletonises a mask and removes spurs for its centrelines; finds the widest judged end.
#include "core/accuracy/system_truth.h"

#include "core/base/median.h"
#include "core/skeleton/thinning.h"
#include "core/skeleton/unit_width_skeleton.h"
#include "core/tree/extraction/skeleton_graph.h"
#include "core/tree/extraction/spur_pruning.h"
#include "core/tree/extraction/vessel_graph.h"

namespace hepatica {

namespace {

constexpr double spur_radii = 0.5;
constexpr double width_reach_mm = 10.0;

}  // namespace

VesselTree centrelines_of(const Mask& mask, Job& job) {
    const Mask skeleton = unit_width(thin(mask, ThinningMethod::queue, job), job);
    VesselGraph graph = skeleton_graph(skeleton, mask);
    prune_spurs(graph, spur_radii, 1.5 * mask.grid.spacing_mm.minCoeff());
    return directed(std::move(graph));
}

std::vector<int> last_of_run(const CentrelineSamples& line, int end, double reach_mm) {
    const auto [first, last] = line.of_segment[line.samples[end].segment];
    const int step = end + 1 < last && line.samples[end + 1].judged ? 1 : -1;
    std::vector<int> run{end};
    double along_mm = 0.0;
    for (int i = end + step; i >= first && i < last && line.samples[i].judged; i += step) {
        along_mm += (line.samples[i].position_mm - line.samples[i - step].position_mm).norm();
        if (along_mm > reach_mm) break;
        run.push_back(i);
    }
    return run;
}

std::optional<int> widest_end(const CentrelineSamples& line) {
    std::vector<int> neighbours(line.samples.size(), 0);
    for (const CentrelineStep& step : line.steps) {
        neighbours[step.from] += line.samples[step.to].judged;
        neighbours[step.to] += line.samples[step.from].judged;
    }
    std::optional<int> widest;
    double width_mm = 0.0;
    for (std::size_t i = 0; i < line.samples.size(); ++i) {
        if (!line.samples[i].judged || neighbours[i] > 1) continue;
        std::vector<double> radii;
        for (const int sample : last_of_run(line, static_cast<int>(i), width_reach_mm))
            radii.push_back(line.samples[sample].radius_mm);
        const double here_mm = median(std::move(radii));
        if (widest && here_mm <= width_mm) continue;
        widest = static_cast<int>(i);
        width_mm = here_mm;
    }
    return widest;
}

}  // namespace hepatica
