// SPDX-License-Identifier: GPL-3.0-or-later
// Sums the segments of each system.
#include "core/tree/system_summary.h"

#include <map>

namespace hepatica {

std::vector<SystemSummary> systems_of(const VesselTree& tree) {
    std::map<VascularSystem, SystemSummary> found;
    for (const VesselSegment& segment : tree.segments) {
        SystemSummary& summary = found[segment.system];
        const double length = length_mm(segment);
        summary.system = segment.system;
        summary.length_mm += length;
        summary.confidence += length * segment.system_confidence;
        if (segment.closes_loop) ++summary.loops;
    }
    for (const int root : roots(tree)) {
        const VesselSegment& segment = tree.segments[root];
        found[segment.system].roots.push_back(
            {segment.points_mm.front(), segment.radii_mm.front()});
    }
    std::vector<SystemSummary> summaries;
    for (auto& [system, summary] : found) {
        summary.confidence /= summary.length_mm;
        summaries.push_back(std::move(summary));
    }
    return summaries;
}

}  // namespace hepatica
